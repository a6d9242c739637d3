# peak FILE COMMAND...: runs COMMAND and writes to FILE the largest resident set of it and all that it starts, together, in KiB, as
# seen twenty times a second. Its status is COMMAND's.
family() {
    local child
    echo "$1"
    for child in $(cat "/proc/$1/task/"*/children 2>/dev/null); do family "$child"; done
}

peak() {
    local file=$1 most=0 sum pid size
    shift
    "$@" &
    local tool=$!
    while kill -0 "$tool" 2>/dev/null; do
        sum=0
        for pid in $(family "$tool"); do
            size=$(awk '/^VmRSS/ {print $2}' "/proc/$pid/status" 2>/dev/null) || true
            sum=$((sum + ${size:-0}))
        done
        ((sum > most)) && most=$sum
        sleep 0.05
    done
    echo "$most" >"$file"
    wait "$tool"
}
