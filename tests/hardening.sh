#!/bin/sh
# The programs and modules are built as a distribution builds them: position independent, with stack
# protectors and checked functions of the C library; nothing that is written is run, and the tables of
# the linker cannot be written.
. "$(dirname "$0")/check.sh"

for file in dioptre dioptre-worker dioptre-images.so dioptre-meshes.so; do
    readelf -hldW --dyn-syms "$BUILD/$file" >"$work/elf" 2>/dev/null || fail "readelf cannot read $file"
    holds "$work/elf" 'Type: +DYN' "$file lies anywhere in memory"
    holds "$work/elf" 'GNU_RELRO' "$file: the linker's tables can only be read"
    holds "$work/elf" 'FLAGS_1\).*NOW' "$file: all of them, from the start"
    holds "$work/elf" 'GNU_STACK.* RW +0x' "$file: the stack is not run"
    if grep -qE 'LOAD .* RWE' "$work/elf"; then fail "$file has memory that is written and run"; else ok "$file has no memory that is written and run"; fi
done
for file in dioptre dioptre-worker; do
    readelf -hldW --dyn-syms "$BUILD/$file" >"$work/elf"
    holds "$work/elf" 'FLAGS_1\).* PIE' "$file is position independent"
    holds "$work/elf" '__stack_chk_fail' "$file has stack protectors"
    holds "$work/elf" '__[a-z]+_chk@' "$file checks what it hands to the C library"
done
finish
