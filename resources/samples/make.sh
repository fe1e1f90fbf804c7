#!/bin/sh
# make.sh PROGRAMS: makes the samples anew with the usar-mission in PROGRAMS. Run it after a change of the recording's
# format or of the results' files; flights differ from one version of the robot to the next.
set -eu
programs=$(cd "${1:?give the folder of usar-mission}" && pwd)
cd "$(dirname "$0")"
rm -rf flight.usarrec scan campaign
"$programs/usar-mission" run sample.mission.json --seed 3 --speed max --record flight.usarrec \
    --export tif,geojson,ply --out scan
# Summaries name their files by whole paths, which are those of another machine here.
sed -i "s#\"$PWD/scan/#\"#g" scan/*.json
"$programs/usar-mission" campaign sample.campaign.json --out campaign --check-every 0 || [ $? -eq 1 ] # Some runs fail.
"$programs/usar-mission" compare campaign --html campaign/report.html || case $? in 1 | 3) ;; *) exit 1 ;; esac
rm -rf campaign/runs
# So do commands; the missions are sought from the campaign's folder.
sed -i "s#$PWD/#../#g" campaign/*.jsonl campaign/report.html
bytes=$(du -cb flight.usarrec scan campaign | tail -n 1 | cut -f 1)
echo "$bytes bytes"
[ "$bytes" -lt 2900000 ] # The rest of the folder takes a little, and a test allows 3,000,000.
