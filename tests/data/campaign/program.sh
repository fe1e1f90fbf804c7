#!/bin/sh
# Stands for usar-mission: does with each seed, its fourth argument, something else. Its last argument is a folder.
# As a worker it does so for each line that it reads.
if [ "$1" = worker ]; then
    while read -r line; do
        number=${line%% *}
        sh "$0" ${line#* }
        status=$?
        [ $status -gt 128 ] && end="by $((status - 128))" || end=$status
        printf '\nended %s %s\n' "$number" "$end"
        printf '\nended %s %s\n' "$number" "$end" >&2
    done
    exit
fi
for folder; do :; done
echo "$4" >> "${0%/*}/calls"
case "$4" in
1 | 11) echo '{"reason":"Well.","rmse_m":1,"files":["a"]}' ;;
2) echo '{"reason":"It fell."}'; exit 1 ;;
3) echo '{"reason":"No such world."}'; exit 2 ;;
4) kill -SEGV $$ ;;
5) kill -KILL $$ ;;
6) echo "terminate called after throwing an instance of 'std::bad_alloc'" >&2; kill -ABRT $$ ;;
7) exec sleep 60 ;;
8) echo "no plugin" >&2; exit 127 ;;
10) kill -KILL $PPID; exec sleep 60 ;;
12) echo "{\"reason\":\"Chance.\",\"worker\":$PPID}" ;;
13) echo '{"reason":"Interrupted; what was scanned until then is kept."}'; exit 1 ;;
14) echo '{"reason":"Well.","files":["/elsewhere"],"unwritten":["run.usarrec: there is no room left."]}' ;;
9) echo "{\"reason\":\"Chance.\",\"pid\":$$}" ;;
esac
echo x > "$folder/map"
