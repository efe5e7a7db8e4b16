#!/bin/bash
# The recipes of doc/farm: films by many processes are the film of one, and a killed job loses its
# own frame only. A Slurm cluster of this machine alone is started for it, and stopped.
. "$(dirname "$0")/check.sh"
export DIOPTRE=$dioptre OPTIONS='-s 64x36 --samples 1'
orbits=$PWD/scenes/orbits.lua
farm=$PWD/doc/farm
services=
cleanup() {
    # shellcheck disable=SC2086 # a list
    [ -z "$services" ] || kill $services 2>/dev/null
    [ -z "$services" ] || wait 2>/dev/null
    rm -rf "$work"
}
trap cleanup EXIT
cd "$work" || exit 1
# shellcheck disable=SC2086 # a list
"$dioptre" animate "$orbits" $OPTIONS --frames 0-11 -o one.mp4

# --- GNU parallel --------------------------------------------------------------------------------
export PARALLEL_HOME=$work/parallel
mkdir -p "$work/parallel" && touch "$work/parallel/will-cite"
expect 0 '' 'parallel' env JOBS=2 "$farm/parallel.sh" "$orbits" frames 11
same one.mp4 frames/film.mp4 'a film by parallel is the film of one process'
[ "$(wc -l <frames/jobs.log)" = 13 ] && ok 'a job a frame' || fail "$(cat frames/jobs.log)"
rm frames/00005.bmp
rm frames/film.mp4
touch -d '2001-01-01' frames/0000[0-4].bmp
expect 0 '' 'parallel once more' env JOBS=2 "$farm/parallel.sh" "$orbits" frames 11
same one.mp4 frames/film.mp4 'a frame that was lost is drawn again'
[ "$(find frames -name '0*.bmp' -not -newermt 2002-01-01 | wc -l)" = 5 ] && ok 'and no other' || fail 'frames are drawn again'

# Names that a shell would take apart.
mkdir 'my films'
cp "$orbits" 'my films/the orbits; 2.lua'
# shellcheck disable=SC2086 # a list
expect 0 '' 'parallel, names with spaces' env JOBS=2 OPTIONS="$OPTIONS" "$farm/parallel.sh" 'my films/the orbits; 2.lua' 'my films/frames' 2
[ -s 'my films/frames/film.mp4' ] && ok 'a film of such names' || fail 'no film of such names'

# --- Slurm ---------------------------------------------------------------------------------------
# cluster: starts munge, the controller and one node on the loopback address. The processes are ours
# alone: they have ports, sockets, keys and folders of their own.
cluster() {
    for program in munged slurmctld slurmd sbatch; do
        PATH=$PATH:/usr/sbin command -v $program >/dev/null || { echo "there is no $program" && return 1; }
    done
    [ "$(id -u)" = 0 ] || { echo 'slurmd wants to be root' && return 1; }
    mkdir -p munge state spool log && chmod 700 munge
    head -c 1024 /dev/urandom >munge/key && chmod 400 munge/key
    /usr/sbin/munged --foreground --force --key-file "$work/munge/key" --socket "$work/munge/socket" \
        --pid-file "$work/munge/pid" --log-file "$work/munge/log" --seed-file "$work/munge/seed" \
        --num-threads 1 >log/munged 2>&1 &
    services="$services $!"
    local port
    port=$((20000 + $$ % 20000))
    cat >slurm.conf <<END
ClusterName=test
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
MailProg=/bin/true
ReturnToService=2
KillWait=1
NodeName=here NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=here Default=YES State=UP
END
    export SLURM_CONF=$work/slurm.conf
    chmod 755 "$work"
    /usr/sbin/slurmctld -D -c >log/slurmctld 2>&1 &
    services="$services $!"
    /usr/sbin/slurmd -D -N here >log/slurmd 2>&1 &
    services="$services $!"
    within has_node && return 0
    echo "no node after two minutes: $(tail -qn 2 log/* | tr '\n' ' ')"
    return 1
}
# has_node: whether the node is there; is_over JOB: whether a job has left the queue.
has_node() { sinfo -h -o %T 2>/dev/null | grep -q idle; }
is_over() { [ -z "$(squeue -h -j "$1" 2>/dev/null)" ]; }
# array TASKS: sends the array off and waits until it is over.
array() {
    job=$(timeout 10 sbatch --parsable --array="$1" "$farm/slurm.sh" "$orbits" "$work/cluster" 11) || return 1
    within is_over "$job"
}
cluster >why
if [ $? = 0 ]; then
    array 0-1 && ok 'an array of two tasks' || fail "the array: $(tail -n 3 log/* dioptre-*.log 2>&1)"
    expect 0 '' 'a film of its frames' "$dioptre" animate cluster/%05d.png --frames 0-11 -o slurm.mp4
    same one.mp4 slurm.mp4 'a film by Slurm is the film of one process'
    # A task is killed in the middle; sent again, it goes on where it was.
    rm -r cluster
    OPTIONS='-s 640x360 --samples 64 --sampling full' job=$(sbatch --parsable --array=0-0 "$farm/slurm.sh" "$orbits" "$work/cluster" 11)
    within [ -e cluster/00001.png ]
    scancel --signal=KILL --full "$job"
    within is_over "$job"
    kept=$(ls cluster/*.png | wc -l)
    [ "$kept" -ge 2 ] && [ "$kept" -lt 12 ] && ok "a killed task has left $kept whole frames" || fail "$kept frames"
    find cluster -name '*.png' -exec touch -d 2001-01-01 {} +
    OPTIONS='-s 640x360 --samples 1' array 0-0 && ok 'the same task once more' || fail 'the task does not end'
    [ "$(find cluster -name '*.png' -not -newermt 2002-01-01 | wc -l)" = "$kept" ] && ok 'what it has left is kept' || fail 'frames are drawn again'
    [ "$(ls cluster/*.png | wc -l)" = 12 ] && ok 'and the rest is drawn' || fail "$(ls cluster)"
else
    echo "skipped: the Slurm recipe, for want of a cluster: $(cat why)"
fi
finish
