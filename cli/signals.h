#pragma once
// Interruption: nothing half-written stays behind.

namespace reliefbake {

/// On SIGINT and SIGTERM: removes the temporaries of writes in progress and the progress line, and exits 130 or 143. On SIGBUS, which a
/// failing disk under mapped working space sends, likewise, with one line and exit code 74.
void leave_no_temporaries_when_interrupted() noexcept;

} // namespace reliefbake
