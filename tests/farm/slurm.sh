#!/usr/bin/env bash
# A Slurm of our own on this machine: munge, slurmctld and two virtual nodes; bakes ../shared/data as an array, kills a node in the middle, and compares the merged result with a local run.
#
#   tests/farm/slurm.sh
#
# Needs root, slurm-wlm and munge (apt install slurm-wlm); a few minutes.
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/../families.sh"
require_tools
data=${RELIEFBAKE_DATA:-$here/../../shared/data}
[[ -d $data ]] || { echo "$this: needs the large set, which takes long enough to kill a node in: no $data" >&2 && exit 2; }
((EUID == 0)) || { echo "$this: needs root, to play two nodes" >&2 && exit 2; }
for program in munged slurmctld slurmd sbatch; do command -v $program >/dev/null || { echo "$this: needs $program (apt install slurm-wlm munge)" >&2 && exit 2; }; done

scratch=$(mktemp -d /tmp/slurm.XXXXXX)
chmod 755 "$scratch"
declare -A daemon
stop() { for name in "${!daemon[@]}"; do kill "${daemon[$name]}" 2>/dev/null || true; done; pkill -f "$scratch" 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$scratch"; }
trap stop EXIT
fail() { echo "$this: $*" >&2 && tail -n 5 "$scratch"/log/{munged,slurmctld,node*} >&2 && exit 1; }

mkdir -p "$scratch"/{munge,state,log}
chmod 700 "$scratch/munge"
head -c 128 /dev/urandom >"$scratch/munge/key" && chmod 600 "$scratch/munge/key"
munged --force --foreground --key-file="$scratch/munge/key" --socket="$scratch/munge/socket" --pid-file="$scratch/munge/pid" --log-file="$scratch/munge/log" --seed-file="$scratch/munge/seed" >"$scratch/log/munged" 2>&1 &
daemon[munged]=$!
host=$(hostname -s)
cat >"$scratch/slurm.conf" <<END
ClusterName=virtual
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$scratch/munge/socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool-%n
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd-%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
ReturnToService=2
SlurmdTimeout=10
JobRequeue=1
NodeName=node1 NodeHostname=$host NodeAddr=127.0.0.1 Port=16818 CPUs=1 RealMemory=3000
NodeName=node2 NodeHostname=$host NodeAddr=127.0.0.1 Port=16819 CPUs=1 RealMemory=3000
PartitionName=main Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$scratch/slurm.conf
sleep 1
slurmctld -D >"$scratch/log/slurmctld" 2>&1 & daemon[slurmctld]=$!
sleep 2
for node in node1 node2; do slurmd -D -N $node >"$scratch/log/$node" 2>&1 & daemon[$node]=$!; done
for ((wait = 0; wait < 30; ++wait)); do [[ $(sinfo -h -t idle -o %D 2>/dev/null) == 2 ]] && break || sleep 1; done
[[ $(sinfo -h -t idle -o %D) == 2 ]] || fail 'two nodes did not come up'

cd "$scratch"
ln -s "$(realpath "$data")" data
shards=6
started=$SECONDS
"$tool" plan data --out farm --name '{stem}_{from}_{kind}' --emit slurm --shards $shards -o bake.sbatch
job=$(sbatch --parsable --output="$scratch/log/task-%a" bake.sbatch)
echo "$(sinfo -h -o '%D nodes, %c processor each'); array of $shards tasks over $("$tool" batch data --out farm --name '{stem}_{from}_{kind}' --dry-run | grep -c '"event":"planned"') assets"

# Kill the second node and all it runs as soon as its task has baked something.
for ((wait = 0; wait < 600; ++wait)); do
    victim=$(squeue -h -j "$job" -w node2 -t running -o %K 2>/dev/null | head -1)
    [[ -n $victim && -s farm/.reliefbake/shards/$victim-of-$shards/ledger.jsonl ]] && break
    sleep 0.1
done
[[ -n ${victim-} ]] || fail 'the second node never ran anything'
lines=$(wc -l <"farm/.reliefbake/shards/$victim-of-$shards/ledger.jsonl")
# All that carries the node's name in its environment, those that would report the end of a task first.
of_node2() { grep -lsz '^SLURMD_NODENAME=node2$' /proc/[0-9]*/environ | cut -d / -f 3; }
steps=$(pgrep -x slurmstepd | while read -r step; do pgrep -P "$step" | while read -r child; do ! grep -qsz '^SLURMD_NODENAME=node2$' "/proc/$child/environ" || echo "$step"; done; done | sort -u)
kill -9 "${daemon[node2]}" $steps $(of_node2) 2>/dev/null || true # shellcheck disable=SC2046,SC2086 # words
wait "${daemon[node2]}" 2>/dev/null || true
unset 'daemon[node2]'
echo "killed node2 in task $victim, after $lines of its assets"

for ((wait = 0; wait < 1800; ++wait)); do [[ -z $(squeue -h -j "$job" 2>/dev/null) ]] && break || sleep 1; done
[[ -z $(squeue -h -j "$job" 2>/dev/null) ]] || fail 'the array did not end'
[[ $(sinfo -h -n node2 -o %t) == down* ]] || fail 'node2 is not down: nothing was tested'
grep -q "requeue.*failure of node node2\|Requeuing" "$scratch/log/slurmctld" || fail 'no task was requeued'
echo "$(grep -c 'Requeuing JobId' "$scratch/log/slurmctld") task requeued, all done after $((SECONDS - started)) s"

code=0
"$tool" merge --out farm || code=$?
((code == 0 || code == 3)) || fail "merge ended with $code"
"$tool" batch data --out local --name '{stem}_{from}_{kind}' --quiet 2>/dev/null || (($? == 3)) || fail 'the local run failed'
diff -r --exclude=.reliefbake farm local >"$scratch/differences" || { head "$scratch/differences" >&2 && fail 'the farm and the local run differ'; }
for out in farm local; do jq -r '.failures[] | "\(.code) \(.id)"' "$out/.reliefbake/summary.json" | sort >"$out.failed"; done
diff farm.failed local.failed >/dev/null || fail 'the farm and the local run failed in other assets'
echo "equal to a local run: $(find farm -type f -not -path '*/.reliefbake/*' | wc -l) files, $(wc -l <farm.failed) assets refused in both"
