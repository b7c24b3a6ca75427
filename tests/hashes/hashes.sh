#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What must stay the same by a bit when code moves: pictures of 24 scenes over models, projections, effects and engines,
# and every kind of file that commands write. One line each, so that two programs can be compared by `diff`.
#
#   tests/hashes/hashes.sh LIMN [DICOM_FOLDER] >before.txt
#
# With NEUTRAL_LIGHT=1 every scene tells of shadows and occlusion of strength 0, which must leave no trace.
set -euo pipefail
limn=$(realpath "$1")
series=${2:+$(realpath "$2")}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work XDG_CONFIG_HOME=$work XDG_DATA_HOME=$work SOURCE_DATE_EPOCH=0
cd "$work"

points='"points":[{"value":-100,"color":[0.8,0.5,0.4],"opacity":0},{"value":200,"color":[0.9,0.6,0.5],"opacity":0.05},{"value":1000,"color":[1,1,0.9],"opacity":0.8}]'
# name, and what differs from the plain scene: keys of the scene file.
scene() {
  printf '{"limn_scene":1,"volume":"phantom:2","transfer_function":{"unit_distance_mm":1,%s},"image":{"width":96,"height":80,"background":[0.05,0.05,0.08]}%s}' \
    "$points" "${2:+,$2}" >"$1.json"
  [ -n "${NEUTRAL_LIGHT:-}" ] || return 0
  python3 - "$1.json" <<'END'
import json, sys
scene = json.load(open(sys.argv[1]))
scene.setdefault("shading", {}).update(shadow={"strength": 0}, occlusion={"strength": 0})
json.dump(scene, open(sys.argv[1], "w"))
END
}
scene plain ""
for model in none classic enhanced robust; do scene "model-$model" "\"shading\":{\"model\":\"$model\"}"; done
for projection in maximum minimum average xray isosurface composite_isosurface; do
  scene "projection-$projection" "\"projection\":\"$projection\",\"isosurface\":{\"value\":250}"
done
scene fog '"fog":{"mode":"exponential","color":[0.2,0.2,0.3],"density_per_mm":0.004}'
scene crop '"crop":{"lower":[0.1,0.2,0.3],"upper":[0.9,0.8,1]}'
scene body '"keep":"body"'
scene gradient-opacity '"gradient_opacity":{"points":[{"gradient":0,"opacity":0},{"gradient":200,"opacity":1}]}'
scene gamma '"shading":{"model":"enhanced","gradient_curve":{"type":"gamma","gamma":0.5},"gradient_reference":300}'
scene light '"shading":{"model":"classic","light_direction":[0.3,0.8,-0.5],"specular_color":"light","two_sided":true,"reflection":"phong"}'
scene smooth '"shading":{"model":"enhanced","gradient_smoothing_mm":3}'
scene jitter '"quality":{"step_voxels":0.7,"preintegrated":false,"early_termination":1,"jitter":true}'
scene preintegrated '"quality":{"step_voxels":2,"preintegrated":true,"early_termination":0.95}'
scene parallel '"camera":{"projection":"orthographic","position":[150,-350,80],"target":[0,0,0],"up":[0,0,1],"fov_y_deg":30,"height_mm":260}'
scene tolerance '"quality":{"tolerance_levels":1}'
scene fine '"quality":{"step_voxels":0.2}'

# `tell NAME FILE…`: what the files hold, whatever their names.
tell() {
  local name=$1
  shift
  printf '%s %s\n' "$(cat "$@" | sha256sum | cut -c1-16)" "$name"
}
render() { "$limn" render "$1.json" --quiet --engine "$2" -o "$3" 2>said || { tell "refused $1 $2" said; return 1; }; }
for file in *.json; do
  name=${file%.json}
  for engine in gl cpu; do render "$name" "$engine" out.png && tell "$name $engine" out.png; done
done
for name in plain model-enhanced projection-maximum crop; do
  for engine in slices slices-back-to-front reference; do render "$name" "$engine" out.png && tell "$name $engine" out.png; done
done

render plain cpu out.jpg && tell "picture .jpg" out.jpg
# Those that tell when they were written are read back: their scene is in them.
for ending in tif exr; do
  render plain cpu "out.$ending" && "$limn" render "out.$ending" --quiet --engine cpu -o again.png && tell "picture .$ending" again.png
done
"$limn" render phantom:2 --quiet --engine cpu --size 96x80 --model compare -o out.png && tell "picture of two models" out.png
for ending in png pdf; do
  "$limn" figure plain.json model-enhanced.json --quiet --size 300 -o "figure.$ending"
done
tell "figure .png" figure.png
pdftoppm -r 200 figure.pdf page && tell "figure .pdf, as painted" page*
"$limn" turntable plain.json --quiet --frames 3 -o turn.frames && tell "turntable" turn.frames/*
for ending in stl ply obj; do
  "$limn" surface phantom:2 --quiet --value 250 -o "surface.$ending" >/dev/null && tell "surface .$ending" "surface.$ending"
done
"$limn" jobs plain.json --view anterior,left -o jobs 2>/dev/null | sed "s#$work##g;s#$limn#limn#g" >jobs.txt && tell "jobs" jobs.txt
"$limn" presets list >presets.txt && tell "list of presets" presets.txt
"$limn" presets show "CT bone" >look.json && tell "preset" look.json
for ending in itf tfi plist clut vp; do
  "$limn" presets convert look.json "look.$ending" 2>/dev/null && tell "look .$ending" "look.$ending"
done
"$limn" effects model-enhanced.json --quiet 2>/dev/null | awk '{ print $1, $2 }' >effects.txt && tell "effects" effects.txt
"$limn" describe bash >bash.txt && tell "completions" bash.txt
"$limn" guide -o guide.html && tell "guide" guide.html
if [ -n "$series" ]; then
  "$limn" info "$series" --quiet | sed "s#$series##g" >info.txt && tell "info of a series" info.txt
  "$limn" render "$series" --quiet --engine cpu --size 96x80 -o out.png && tell "picture of a series" out.png
fi
