#!/bin/sh
# Makes every picture in docs/pictures: `sh docs/pictures.sh`, with `delone` on the PATH, and a Python with SciPy for one
# of them (`DELONE_PYTHON` names another than python3). Commands are those of the pages, which tell what they do; the
# data of the tutorials are taken from there, too. Other pages have other ways: CONTRIBUTING.md names them.
set -eu
docs=$(cd "$(dirname "$0")" && pwd)
out=$docs/pictures
python=${DELONE_PYTHON:-python3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cp -r "$docs/queries" "$docs/doctor" .

# Prints the blocks of a language on a page, but for lines that install or serve.
blocks() {
    awk -v begin="\`\`\`$2" '
        $0 == begin { on = 1; next }
        /^```/ { on = 0 }
        on && !/^cargo / && !/^delone theatre/' "$docs/$1"
}

# Runs what a page tells to type, in order.
tell() {
    blocks "$1" python >heat.py
    blocks "$1" sh | sed "s#^python3 #$python #" >told.sh
    sh -e told.sh >told.log 2>&1 || { cat told.log; echo "$1 fails" >&2; exit 1; }
}

tell start.md
cp yard.png "$out/yard.png"
tell tutorials/elements.md
cp mesh.png "$out/elements-mesh.png"
cp heat.png "$out/elements-heat.png"
tell tutorials/maps.md
cp sick.png "$out/maps-sick.png"
cp parcels.png "$out/maps-parcels.png"
cp land.png "$out/maps-land.png"
tell tutorials/students.md
cp fortune.png "$out/students-fortune.png"
tell exactness.md
cp grid.png "$out/exactness-grid.png"
cp tangle.png "$out/exactness-tangle.png"
"$python" "$out/floats.py" "$out/exactness-floats.png"
