#!/usr/bin/env bash
# Our glTF files before Khronos' validator, and our tangents beside the reference MikkTSpace, both from npm. Usage: gltf_by_npm.sh RELIEFBAKE.
# Prints "SKIPPED: reason" where npm or its registry is missing. RELIEFBAKE_DATA: real meshes too.
set -euo pipefail
tool=$1
data=${RELIEFBAKE_DATA:-$(dirname "$0")/../../../../shared/data}
data=$(cd "$data" 2>/dev/null && pwd || true)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for program in npm node; do
    command -v "$program" >/dev/null || { echo "SKIPPED: no $program"; exit 0; }
done
cd "$folder"
timeout 60 npm install --silent --no-audit --no-fund gltf-validator mikktspace@1 >npm.log 2>&1 || { echo "SKIPPED: npm cannot install gltf-validator and mikktspace"; exit 0; }

# A torus with uneven sides whose texture is mirrored on one half and has a seam, and a patch without any area in the texture.
cat >torus.mjs <<'JS'
import { writeFileSync } from 'node:fs';
const rings = 24, sides = 12;
let text = '';
const noise = (k) => Math.sin(k * 12.9898) * 43758.5453 % 1;
for (let j = 0; j <= sides; ++j) for (let i = 0; i <= rings; ++i) {
    const u = 2 * Math.PI * (i % rings + 0.2 * noise(i % rings + 31 * (j % sides))) / rings, v = 2 * Math.PI * (j % sides) / sides;
    const s = 1 + 0.4 * Math.cos(v);
    text += `v ${s * Math.cos(u)} ${s * Math.sin(u)} ${0.4 * Math.sin(v)}\n`;
    text += `vn ${Math.cos(v) * Math.cos(u)} ${Math.cos(v) * Math.sin(u)} ${Math.sin(v)}\n`;
    text += `vt ${j < 2 ? 0.25 : Math.abs(i / rings - 0.5)} ${j < 2 ? 0.25 : j / sides}\n`;
}
const c = (i, j) => { const k = j * (rings + 1) + i + 1; return `${k}/${k}/${k}`; };
for (let j = 0; j < sides; ++j) for (let i = 0; i < rings; ++i)
    text += `f ${c(i, j)} ${c(i + 1, j)} ${c(i + 1, j + 1)}\nf ${c(i, j)} ${c(i + 1, j + 1)} ${c(i, j + 1)}\n`;
writeFileSync('torus.obj', text);
JS
node torus.mjs

cat >check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
const require = createRequire(import.meta.url);
const validator = require('gltf-validator'), mikktspace = require('mikktspace');
let failed = false;
const fail = (words) => { console.error('FAILED: ' + words); failed = true; };

function parts(bytes) {
    const length = bytes.readUInt32LE(12);
    return { json: JSON.parse(bytes.subarray(20, 20 + length)), binary: bytes.subarray(28 + length) };
}
const arrays = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array }, sizes = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
function array({ json, binary }, index) {
    const a = json.accessors[index], view = json.bufferViews[a.bufferView], n = sizes[a.type], Type = arrays[a.componentType];
    const out = new Float64Array(a.count * n), stride = view.byteStride ?? n * Type.BYTES_PER_ELEMENT;
    const start = (view.byteOffset ?? 0) + (a.byteOffset ?? 0);
    for (let k = 0; k < a.count; ++k) out.set(new Type(binary.buffer.slice(binary.byteOffset + start + k * stride, binary.byteOffset + start + k * stride + n * Type.BYTES_PER_ELEMENT)), k * n);
    return { values: out, n };
}
for (const file of process.argv.slice(2)) {
    const bytes = readFileSync(file);
    const report = await validator.validateBytes(new Uint8Array(bytes), { externalResourceFunction: async (uri) => new Uint8Array(readFileSync(uri)) });
    const issues = report.issues.messages.filter((m) => m.severity === 0);
    if (issues.length) fail(file + ': ' + JSON.stringify(issues.slice(0, 3)));
    console.log(`${file}: ${report.issues.numErrors} errors, ${report.issues.numWarnings} warnings`);
    if (!file.endsWith('.glb') || file.includes('keep')) continue;
    const glb = parts(bytes);
    for (const mesh of glb.json.meshes) for (const primitive of mesh.primitives) {
        const at = primitive.attributes;
        if (!('TEXCOORD_0' in at) || !('TANGENT' in at)) continue;
        const index = array(glb, primitive.indices).values;
        const spread = (semantic) => {
            const { values, n } = array(glb, at[semantic]), out = new Float32Array(index.length * n);
            index.forEach((v, k) => out.set(values.subarray(v * n, v * n + n), k * n));
            return out;
        };
        const p = spread('POSITION'), normal = spread('NORMAL'), uv = spread('TEXCOORD_0'), ours = spread('TANGENT');
        const theirs = mikktspace.generateTangents(p, normal, uv);
        let compared = 0, wrong = 0;
        for (let k = 0; k < index.length; ++k) {
            const t = theirs.subarray(4 * k, 4 * k + 4), o = ours.subarray(4 * k, 4 * k + 4);
            if (t[0] === 1 && t[1] === 0 && t[2] === 0 && t[3] === -1) continue; // the reference found no direction
            ++compared;
            const apart = Math.hypot(t[0] - o[0], t[1] - o[1], t[2] - o[2]);
            if (apart > 1e-3 || t[3] !== -o[3]) ++wrong; // glTF's texture runs down
        }
        console.log(`${file}: ${wrong} of ${compared} tangents differ from the reference`);
        if (compared < index.length / 2) fail(file + ': too few to compare');
        if (wrong > compared * 1e-3) fail(file + ': tangents differ');
    }
}
process.exit(failed ? 1 : 0);
JS
"$tool" quadric torus.obj -o torus.glb --frame uv --quiet
"$tool" quadric torus.obj -o ab.gltf --terms ab --quiet
"$tool" quadric torus.obj -o keepuv.glb --store uv:1 --quiet 2>/dev/null
"$tool" quadric torus.obj -o keepcolor.glb --store color --quiet 2>/dev/null
"$tool" quadric torus.glb -o again.glb --frame uv --quiet
files=(torus.glb ab.gltf keepuv.glb keepcolor.glb again.glb)
for name in spot.obj monsterfrog_mapped.obj mx_teapot.obj cup.obj boombox.glb; do
    [[ -n $data && -f $data/meshes/$name ]] || continue
    "$tool" quadric "$data/meshes/$name" -o "${name%.*}.glb" --frame uv --quiet
    files+=("${name%.*}.glb")
done
node check.mjs "${files[@]}" && echo "all valid"
