#!/bin/sh
# slurm_box.sh FOLDER CONF JOB RESULTS LINES: submits JOB to a Slurm of two nodes on this machine, kills one node once
# RESULTS has LINES lines, and waits for the report. It must run in namespaces of its own (unshare --net --mount
# --pid --fork --mount-proc), so that its end ends everything that it has started.
set -eu
folder=$1 conf=$2 job=$3 results=$4 lines=$5
export SLURM_CONF=$folder/slurm.conf
mkdir -p "$folder/state" "$folder/spool.n1" "$folder/spool.n2"
sed "s#@FOLDER@#$folder#" "$conf" > "$SLURM_CONF"
# With the loopback interface alone, getaddrinfo does not find 127.0.0.1 (AI_ADDRCONFIG).
ip link set lo up
ip link add veth0 type veth peer name veth1
ip address add 10.77.0.1/24 dev veth0
ip link set veth0 up
ip link set veth1 up

slurmctld -D > "$folder/slurmctld.out" 2>&1 &
sleep 2
for node in n1 n2; do
    setsid slurmd -D -N "$node" > "$folder/$node.out" 2>&1 &
done
sleep 3
cd "$folder"
sbatch "$job"

count() { cat "$results"/shard-*.jsonl 2>/dev/null | wc -l; }
until [ "$(count)" -ge "$lines" ]; do sleep 1; done
# A machine that loses its power takes its tasks with it, and what watches over them. Between two parts it has none.
tasks() { grep -lsz SLURMD_NODENAME=n2 /proc/[0-9]*/environ | cut -d/ -f3; }
until [ -n "$(tasks)" ]; do sleep 0.2; done
echo "killed n2 with $(count) results"
watchers=$(for task in $(tasks); do ps -o ppid= -p "$task" || true; done)
kill -9 "$(cat "$folder/slurmd.n2.pid")" $watchers $(tasks) 2>/dev/null || true

until [ -s "$results/report.html" ]; do sleep 1; done
echo "reported with $(count) results"
grep "requeue job JobId" "$folder/slurmctld.log"
