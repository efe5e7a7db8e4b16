# What `make bench` and `make peers` keep for the READMEs; sourced by their scripts. Gives `figures`, the
# folder. doc/figures.sh writes the tables.
figures=${FIGURES:-doc/figures}

# begin_figures NAME COLUMNS: begins a table, with the machine that it is measured on.
begin_figures() {
    mkdir -p "$figures"
    {
        echo "# $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1 | tr -s ' ,' ' '),$(date -u +%Y-%m-%d),${MADE_WITH:-}"
        echo "$2"
    } >"$figures/$1.csv"
}

# keep_figures NAME ROW: adds a row.
keep_figures() {
    echo "$2" >>"$figures/$1.csv"
}
