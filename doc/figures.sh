#!/bin/sh
# Writes the figures of README.md, README.fr.md, doc/web.md and doc/marching.md, between `<!-- figures: NAME -->` and
# `<!-- end -->`, from the tables of doc/figures. `make bench`, `make peers` and `make bench-web` call it after measuring.
#   doc/figures.sh [FOLDER]: writes the files there instead.
set -eu
export LC_ALL=C.UTF-8
cd "$(dirname "$0")/.."
folder=${1:-.}

# fill FILE LANGUAGE: the file with its figures.
fill() {
    awk -F, -v language="$2" '
# words(english, french): what the language says.
function words(english, french) { return language == "fr" ? french : english }
# number(x): three digits that count, as the language writes them.
function number(x,  text) {
    if (x == "") return "–"
    text = x >= 99.5 ? sprintf("%d", x + 0.5) : x >= 9.95 ? sprintf("%.1f", x) : sprintf("%.2g", x)
    if (language == "fr") sub(/\./, ",", text)
    return text
}
# grouped(x): a whole number in groups of three digits.
function grouped(x,  text) {
    for (text = ""; length(x) > 3; x = substr(x, 1, length(x) - 3)) text = " " substr(x, length(x) - 2) text
    return x text
}
# times(theirs, ours): how many times as long theirs takes.
function times(theirs, ours) { return ours == "" ? "–" : number(theirs / ours) }
# name(key): what a scene or a mesh is called.
function name(key) {
    if (key == "box") return words("the box", "la boîte")
    if (key == "clear-box") return words("the box with clear glass, which Tachyon draws too", "la boîte au verre qui ne réfracte pas, que Tachyon dessine aussi")
    if (key == "shapes") return words("every simple shape", "toutes les formes simples")
    if (key == "spot") return words("a mesh, twice", "un maillage, deux fois")
    if (key == "glass-box") return words("the box, with a glass ball, a bubble, a tinted pane", "la boîte, avec une boule de verre, une bulle, une vitre teintée")
    if (key == "glass") return words("nothing but mirrors and glass, two lights", "rien que des miroirs et du verre, deux lampes")
    if (key == "pictures") return words("a map on a sphere, a glass ball, a panorama", "une carte sur une sphère, une boule de verre, un panorama")
    if (key == "sun") return words("the light of a sun", "la lumière d’un soleil")
    if (key == "fading") return words("lights that weaken with the square of the distance", "des lampes qui faiblissent avec le carré de la distance")
    if (key == "soft") return words("soft shadows: 4096 rays per pixel, 4096 lights in POV-Ray", "des ombres douces : 4096 rayons par pixel, 4096 lampes pour POV-Ray")
    if (key == "endless-frames") return words("frames of cubes without end", "armatures de cubes sans fin")
    if (key == "menger-sponge") return words("Menger sponge", "éponge de Menger")
    if (key == "turned-frame") return words("turned frame of a cube", "armature d’un cube, tournée")
    if (key == "stanford-bunny") return words("Stanford bunny", "lapin de Stanford")
    if (key == "dragon-871k") return words("Stanford dragon", "dragon de Stanford")
    return key
}
# heads(names, count): the head of a table.
function heads(cells,  count, row) { print "| " cells " |"; count = split(cells, row, " [|] "); printf "|"; while (count-- > 0) printf "---|"; print "" }
# measured(table): where and when a table was measured.
function measured(table,  parts) {
    split(machine[table], parts, ", ?")
    if (language == "fr") gsub(/;/, " ;", parts[3])
    print words("Measured on ", "Mesurés sur ") parts[1] ", " parts[2] ", " parts[3] (parts[4] == "" ? "" : "," parts[4]) ".\n"
}
# march_settings(): a row per length of steps and per footprint, a column per scene: pixels off, time.
function march_settings(  i, j, cell, cells, rows_of, columns, line) {
    for (i = 1; i <= rows["march-settings"]; i++) {
        split(row["march-settings", i], cell, ",")
        cells[cell[1], cell[2], cell[3] + 0] = sprintf("%.2f %%, %s ms", cell[5], number(cell[4]))
    }
    heads("setting | endless frames | all neighbours evaluated | cube frame | melting | Menger sponge")
    split("scenes/endless-frames tests/bench/frames-asked scenes/cube-frame scenes/melting scenes/menger-sponge", columns, " ")
    split("relaxation,1,steps as long as allowed;relaxation,1.2,1.2 times;relaxation,1.6,1.6 times;relaxation,0,by the slope;" \
          "footprint,0.0625,footprint 1/16;footprint,0.125,footprint 1/8;footprint,0.25,footprint 1/4;footprint,0.5,footprint 1/2", rows_of, ";")
    for (i = 1; i in rows_of; i++) {
        split(rows_of[i], cell, ",")
        line = "| " cell[3] " |"
        for (j = 1; j in columns; j++) line = line " " cells[columns[j] ".lua", cell[1], cell[2] + 0] " |"
        print line
    }
}
# acne(): a sentence on the pixels with acne or a leak.
function acne(  i, cell, none, wrong, others) {
    for (i = 1; i <= rows["acne"]; i++) {
        split(row["acne", i], cell, ",")
        wrong = cell[3] + cell[4]
        sub(/\.lua$/, "", cell[1])
        if (wrong == 0) none++
        else others = others (others == "" ? "" : ", ") "`" cell[1] "` " grouped(wrong)
    }
    print words("In float, with the offset `bound`, ", "En float, avec le décalage `bound`, ") (none + 0) words(" of the ", " des ") rows["acne"] \
        words(" scenes have not one pixel of ", " scènes n’ont pas un seul pixel sur ") grouped(cell[2]) \
        words(" with acne or a leak.", " avec acné ou fuite.") \
        (others == "" ? "" : words(" The others have: ", " Les autres en ont : ") others ".")
}
function table_of(what,  i, cell, other, best) {
    if (what == "acne") { acne(); return }
    measured(what == "speed" ? "speed" : what)
    if (what == "march-settings") { march_settings(); return }
    if (what == "engines") {
        heads(words("engine | threads | ms per picture | Mrays/s | times `f32x1` | off by one step | by more, against `f128x1`", "moteur | fils | ms par image | Mrayons/s | fois plus rapide que `f32x1` | pixels écartés d’un niveau | de plus d’un niveau, par rapport à `f128x1`"))
        for (i = 1; i <= rows[what]; i++) {
            split(row[what, i], cell, ",")
            print "| `" cell[1] "` | " cell[2] " | " number(cell[3]) " | " number(cell[4]) " | " number(cell[5]) " | " grouped(cell[7]) " | " grouped(cell[8]) " |"
        }
    } else if (what == "speed") {
        heads(words("scene | peer | its ms per picture | `f32x8`, ms | `f32x16`, ms | times `f32x8` | times `f32x16`", "scène | comparé à | ses ms par image | `f32x8`, ms | `f32x16`, ms | fois `f32x8` | fois `f32x16`"))
        for (i = 1; i <= rows[what]; i++) {
            split(row[what, i], cell, ",")
            print "| " name(cell[1]) " | " (cell[2] == "povray" ? "POV-Ray" : "Tachyon") " | " number(cell[3]) " | " number(cell[4]) " | " number(cell[5]) " | " times(cell[3], cell[4]) " | " times(cell[3], cell[5]) " |"
        }
    } else if (what == "pictures") {
        heads(words("scene | pixels | off by more than a step from POV-Ray | of them on no edge", "scène | pixels | écartés de plus d’un niveau de POV-Ray | dont sur aucune arête"))
        for (i = 1; i <= rows[what]; i++) {
            split(row[what, i], cell, ",")
            print "| " name(cell[1]) " | " grouped(cell[2]) " | " grouped(cell[3]) " | " grouped(cell[4]) " |"
        }
    } else if (what == "meshes") {
        heads(words("mesh | engine | camera rays | random rays | shadow rays | building | bytes per triangle, Embree’s", "maillage | moteur | rayons de la caméra | au hasard | d’ombre | construction | octets par triangle ; Embree"))
        for (i = 1; i <= rows[what]; i++) {
            split(row[what, i], cell, ",")
            print "| " (cell[1] == "spot" ? "Spot" : name(cell[1])) " | `" cell[2] "` | " number(cell[3]) " | " number(cell[4]) " | " number(cell[5]) " | " number(cell[6]) " | " number(cell[7]) words(", ", " ; ") number(cell[8]) " |"
        }
    } else if (what == "marching") {
        heads(words("scene | `f32x8`, ms | `f32x16`, ms | Mesa, ms | pixels off by more than a step", "scène | `f32x8`, ms | `f32x16`, ms | Mesa, ms | pixels écartés de plus d’un niveau"))
        for (i = 1; i <= rows[what]; i++) {
            split(row[what, i], cell, ",")
            print "| " name(cell[1]) " | " number(cell[2]) " | " number(cell[3]) " | " number(cell[4]) " | " number(100 * cell[6] / cell[5]) " % |"
        }
    } else if (what == "web-window") {
        heads("what | with threads | with one thread | goal")
        for (i = 1; i <= rows[what]; i++) {
            split(row[what, i], cell, ",")
            print "| " web_row(cell[1], number(cell[2]) " | " number(cell[3])) " |"
        }
    } else if (what == "web-engines") {
        heads("scene | `f32x4`, desktop | `f32x4`, page | page’s speed | `f32x8`, desktop | `f32x8`, page | page’s speed")
        for (i = 1; i <= rows[what]; i++) {
            split(row[what, i], cell, ",")
            narrow[i] = cell[2] / cell[3]; wide[i] = cell[4] / cell[5]
            print "| " cell[1] " | " number(cell[2]) " | " number(cell[3]) " | " number(narrow[i]) " | " number(cell[4]) " | " number(cell[5]) " | " number(wide[i]) " |"
        }
        print "| **median** (goals: 0.8 and 0.55) | | | **" number(median(narrow, rows[what])) "** | | | **" number(median(wide, rows[what])) "** |"
    }
}
# web_row(key, values): a row of the table of the page, with its unit and its goal.
function web_row(key, values) {
    if (key == "cold") return "first picture of the box in a new browser, ms | " values " | 1000"
    if (key == "warm") return "the same when the page is loaded again, ms | " values " | 400"
    if (key == "key") return "from a key to the coarse picture, median, ms | " values " | 20"
    if (key == "key_worst") return "the same, longest, ms | " values " | "
    if (key == "idle") return "processor while nothing happens, % of a core | " values " | 0.5"
    if (key == "gzip") return "fetched before the first picture, MB by `gzip -9` | " values " | 2"
    if (key == "brotli") return "the same by Brotli, MB | " values " | 2"
    return key " | " values " | "
}
# median(values, count): of the values 1 to count.
function median(values, count,  i, j, t, sorted) {
    for (i = 1; i <= count; i++) sorted[i] = values[i]
    for (i = 2; i <= count; i++) for (j = i; j > 1 && sorted[j] < sorted[j - 1]; j--) { t = sorted[j]; sorted[j] = sorted[j - 1]; sorted[j - 1] = t }
    return count % 2 ? sorted[(count + 1) / 2] : (sorted[count / 2] + sorted[count / 2 + 1]) / 2
}
FILENAME ~ /\.csv$/ {
    if (FNR == 1) { table = FILENAME; sub(/.*\//, "", table); sub(/\.csv$/, "", table); machine[table] = substr($0, 3) }
    else if (FNR > 2) row[table, ++rows[table]] = $0
    next
}
/^<!-- figures: / {
    what = $0; sub(/^<!-- figures: /, "", what); sub(/ -->$/, "", what)
    print; print ""
    if (!(what in rows)) { print "figures: there is no table " what > "/dev/stderr"; exit failed = 1 }
    table_of(what)
    print ""
    inside = 1
    next
}
/^<!-- end -->$/ { inside = 0 }
!inside
END { exit failed }
' doc/figures/*.csv "$1" >"$folder/$1.new"
    mv "$folder/$1.new" "$folder/$1"
}
fill README.md en
fill README.fr.md fr
mkdir -p "$folder/doc"
fill doc/web.md en
fill doc/marching.md en
