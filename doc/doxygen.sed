# What Doxygen reads in place of a source file (FILTER_PATTERNS in Doxyfile); no line moves.

# Every file is documented, even one that says nothing of itself: then Doxygen looks at its functions.
1s|^|/** @file */ |

# A constant in an enum of its own is shown, and linked to, by its name.
s/^enum \{ ([A-Z_0-9]+) = ([^,=]*) \};$/#define \1 \2/

# An assertion for the compiler is no function.
s/^_Static_assert\(.*\);$//
/^_Static_assert\(/,/\);$/s/.*//

# A class is declared by the list of all classes, and says itself what it is.
s|^const (Scene)?(Shape\|Light)Class \w+_class = |/** A class: its vtable. */ &|

# A method of the laboratory is a function.
s/^METHOD\((\w+), (\w+), (\w+)\) \{/static \3 \1(const \2 *in) {/

# A step of a tape is a function.
s/^TAPE_STEP\((\w+),.*/static void tape_\1(real *registers, const TapeStep *step);/
s/^ +dual_.*\)\)$//

# Columns of a list of properties, defined where the list is read.
s/^#define (COLOR|NUMBER|PROPERTY)\(name, value\).*//
