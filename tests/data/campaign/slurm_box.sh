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
echo "killed n2 with $(count) results"
# A machine that loses its power takes its tasks with it.
node=$(cat "$folder/slurmd.n2.pid")
steps=$(pgrep -P "$node" || true)
kill -9 "$node"
for step in $steps; do
    pkill -9 -P "$step" || true
    kill -9 "$step" || true
done

until [ -s "$results/report.html" ]; do sleep 1; done
echo "reported with $(count) results"
grep "requeue JobId" "$folder/slurmctld.out"
