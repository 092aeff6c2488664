#!/usr/bin/env bash
# Makes a recording of each LADAR sweep of an Argoverse 2 log, with its labels, for the training of
# the discriminator:
#   scripts/argoverse-sweeps.sh LOG_DIR OUT_DIR NAME
# LOG_DIR holds annotations.csv (boxes in the vehicle's frame) and lidar_TIMESTAMP.bin (float32 x, y, z,
# intensity, laser, time; vehicle's frame). Writes OUT_DIR/NAME_SWEEP_LASERS.rawlog and .csv and prints
# their names: the sweep seven times over, as seen by a vehicle that stands among what stands, so that
# its objects become tracks; with all 64 lasers, 32 of them and 16.
set -euo pipefail
[ $# -eq 3 ] || { sed -n '4s/^# *//p' "$0" >&2; exit 2; }
log=$1 out=$2 name=$3
[ -f "$log/annotations.csv" ] || { echo "$log: no annotations.csv of an Argoverse 2 log" >&2; exit 1; }
[ -d "$out" ] || { echo "$out: no such folder" >&2; exit 1; }
root=$(cd "$(dirname "$0")/.." && pwd)
apps=${VDAMF_APPS:-$root/build/${VDAMF_PRESET:-release}/apps}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sensor_x=1.35 sensor_z=1.64 # on the vehicle, m
times=$(seq -f %.1f 1700000000 0.1 1700000000.6)

# The hits of the lasers that an awk condition on `laser` keeps, as PCD in the sensor's frame.
cloud()
{
    od -An -v -t f4 -w24 "$1" | awk -v sx=$sensor_x -v sz=$sensor_z "
        { laser = int(\$5) } $2 { hit[n++] = sprintf(\"%.3f %.3f %.3f %.3f\", \$1 - sx, \$2, \$3 - sz, \$4 / 255) }
        END { printf \"VERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n\"
              printf \"WIDTH %d\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS %d\nDATA ascii\n\", n, n
              for (i = 0; i < n; ++i) print hit[i] }"
}

# truth.csv of a sweep, at all of the times.
truth()
{
    awk -F, -v stamp="$1" -v times="$times" -v sx=$sensor_x '
        BEGIN { n = split(times, time, "\n")
                print "time_s,object_id,class,x_m,y_m,z_m,heading_rad,length_m,width_m,height_m," \
                      "speed_mps,points,sensor_x_m,sensor_y_m,sensor_heading_rad" }
        function classOf(c) {
            if (c == "REGULAR_VEHICLE") return "Car"
            if (c ~ /BUS$/) return "Bus"
            if (c ~ /TRUCK|LARGE_VEHICLE|VEHICULAR_TRAILER/) return "Truck"
            if (c ~ /CYCL/) return "Cyclist"
            return c == "PEDESTRIAN" ? "Pedestrian" : "Other" }
        $1 == stamp { row[++rows] = sprintf("%s,%s,%s,%s,%.4f,%.6f,%s,%s,%s,0,%s,%s,0,0", $2, \
            classOf($3), $11, $12, $13 - $6 / 2, 2 * atan2($10, $7), $4, $5, $6, $14, sx) }
        END { for (t = 1; t <= n; ++t) for (r = 1; r <= rows; ++r) print time[t] "," row[r] }
        ' "$log/annotations.csv"
}

sweep=0
for file in "$log"/lidar_*.bin; do
    sweep=$((sweep + 1))
    stamp=$(basename "$file" .bin)
    for lasers in 64:1 32:laser\<32 16:laser\>=32\&\&laser%2==0; do
        one=${name}_${sweep}_${lasers%%:*}
        rm -rf "$work/$one"
        mkdir "$work/$one"
        cloud "$file" "${lasers#*:}" > "$work/$one/0.pcd"
        for copy in 1 2 3 4 5 6; do ln "$work/$one/0.pcd" "$work/$one/$copy.pcd"; done
        echo "$times" > "$work/times"
        { echo 1699999999.9; echo "$times"; echo 1700000000.7; } | sed 's/$/ 0 0 0 0 0 0 1/' > "$work/poses"
        "$apps/vdamf-import" clouds "$work/$one" --times "$work/times" --poses "$work/poses" \
            --sensor-pose $sensor_x 0 $sensor_z 0 0 0 -o "$out/$one.rawlog" --overwrite > /dev/null 2>&1
        truth "${stamp#lidar_}" > "$out/$one.csv"
        echo "$one"
    done
done
