# What Doxygen reads in place of a source file (FILTER_PATTERNS in Doxyfile); no line moves.

# Every file is documented, even one that says nothing of itself: then Doxygen looks at its functions.
1s|^|/** @file */ |

# A constant in an enum of its own is shown, and linked to, by its name.
s/^enum \{ ([A-Z_0-9]+) = ([^,=]*) \};$/#define \1 \2/

# An assertion for the compiler is no function.
s/^_Static_assert\(.*\);$//
