# Comparisons of vectors of 256 bits become calls of functions, in LLVM's text, before it is optimized:
#
#     awk -v bodies=FILE -f src/web/comparisons.awk IN.ll >OUT.ll
#
# LLVM makes truth values of one bit of them, and joins those: `a < b & active` of eight floats is a vector of eight bits, which
# WebAssembly's registers do not have. Its backend takes such a vector apart and puts it together lane by lane, by some 20 instructions.
# What a call gives stays what the source says: as many integers, 0 or -1. The bodies, which compare half by half, are written to
# FILE, to be linked and inlined when all is optimized.

# As clang writes `a < b`: the comparison and, on the next line, its bits as integers.
/ = [fi]cmp [a-z]+ <(8 x float|8 x i32|4 x double|4 x i64)> / {
    match($0, /<[0-9]+ x [a-z0-9]+> /)
    type = substr($0, RSTART, RLENGTH - 1)
    operands = substr($0, RSTART + RLENGTH)
    comma = match(operands, /^<[^>]*>/) ? RLENGTH + 1 : index(operands, ",")
    lanes = substr(type, 2, 1)
    mask = "<" lanes " x i" 256 / lanes ">"
    name = "@compare_" $3 "_" $4 "_" lanes "_" $7
    sub(/>$/, "", name)
    types[name] = type
    masks[name] = mask
    comparisons[name] = $3 " " $4
    print "  " $1 " = call " mask " " name "(" type " " substr(operands, 1, comma - 1) ", " type substr(operands, comma + 1) ")"
    getline
    if ($3 " " $4 " " $5 " " $6 != "sext <" lanes " x i1>") {
        print "these truth values become no integers: " $0 >"/dev/stderr"
        exit 1
    }
    print "  " $1 " = bitcast " mask " " $7 " to " mask
    next
}
/^target / { print >bodies }
{ print }

# @return Lane numbers `first` to `first` + `count` - 1, as shufflevector takes them.
function lane_list(first, count,    list, i) {
    list = "<" count " x i32> <i32 " first
    for (i = first + 1; i < first + count; i++) {
        list = list ", i32 " i
    }
    return list ">"
}

# Writes a function that compares half by half.
function print_body(name,    type, lanes, half, half_type, half_mask, i, k, operand) {
    type = types[name]
    lanes = substr(type, 2, 1)
    half = lanes / 2
    half_type = "<" half substr(type, 3)
    half_mask = "<" half substr(masks[name], 3)
    print "define " masks[name] " " name "(" type " %a, " type " %b) alwaysinline {" >bodies
    for (i = 0; i < 2; i++) {
        for (k = 1; k <= 2; k++) {
            operand = "%" substr("ab", k, 1)
            print "  " operand i " = shufflevector " type " " operand ", " type " poison, " lane_list(half * i, half) >bodies
        }
        print "  %bits" i " = " comparisons[name] " " half_type " %a" i ", %b" i >bodies
        print "  %mask" i " = sext <" half " x i1> %bits" i " to " half_mask >bodies
    }
    print "  %mask = shufflevector " half_mask " %mask0, " half_mask " %mask1, " lane_list(0, lanes) >bodies
    print "  ret " masks[name] " %mask\n}" >bodies
}

END {
    for (name in types) {
        print "declare " masks[name] " " name "(" types[name] ", " types[name] ") nounwind willreturn speculatable memory(none)"
        print_body(name)
    }
}
