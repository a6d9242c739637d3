#!/usr/bin/env bash
# Reads our KTX2 files with npm's ktx-parse, an implementation that is not ours. Usage: ktx_parse.sh RELIEFBAKE HEIGHT.
# Prints "SKIPPED: reason" where npm or its registry is missing.
set -euo pipefail
tool=$1 height=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for program in npm node; do
    command -v "$program" >/dev/null || { echo "SKIPPED: no $program"; exit 0; }
done
cd "$folder"
timeout 60 npm install --silent --no-audit --no-fund ktx-parse@1 >npm.log 2>&1 || { echo "SKIPPED: npm cannot install ktx-parse"; exit 0; }
for bits in 8 16 half float; do
    "$tool" cone "$height" -o "$bits.ktx2" --bits "$bits" --mips --quiet
    "$tool" cone "$height" -o "one$bits.ktx2" --bits "$bits" --quiet
done
cat >read.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { read } from 'ktx-parse';
const formats = { 8: 37, 16: 91, half: 97, float: 109 }, bytes = { 8: 4, 16: 8, half: 8, float: 16 };
const check = (truth, words) => { if (!truth) { console.error('FAILED: ' + words); process.exitCode = 1; } };
for (const prefix of ['', 'one']) for (const bits of Object.keys(formats)) {
    const file = prefix + bits + '.ktx2', k = read(readFileSync(file));
    const value = k.keyValue.reliefbake; // bytes: ktx-parse takes only KTX's own keys for text
    const facts = JSON.parse((typeof value === 'string' ? value : new TextDecoder().decode(value)).replace(/\0+$/, ''));
    check(k.vkFormat === formats[bits], file + ' format ' + k.vkFormat);
    check(k.pixelWidth === facts.width && k.pixelHeight === facts.height, file + ' size');
    check(k.levels.length === (prefix ? 1 : facts.levels), file + ' levels ' + k.levels.length);
    check(k.keyValue.KTXwriter.startsWith('reliefbake '), file + ' writer');
    check(k.supercompressionScheme === 0, file + ' scheme');
    const dfd = k.dataFormatDescriptor[0];
    check(dfd.colorModel === 1 && dfd.transferFunction === 1 && dfd.samples.length === 4, file + ' descriptor');
    check(dfd.bytesPlane[0] === bytes[bits], file + ' bytes of a texel');
    k.levels.forEach((level, n) => {
        const size = Math.max(1, facts.width >> n) * Math.max(1, facts.height >> n) * bytes[bits];
        check(level.levelData.byteLength === size, file + ' bytes of level ' + n);
    });
}
if (!process.exitCode) console.log('ktx-parse reads all 8 files');
JS
node read.mjs
