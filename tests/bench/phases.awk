# Sums up by phase what a profile counts by function. Called by profile.sh with -v rays=N -v ns=NS and
# -v lanes=L, and three files: the instructions of the program (objdump), the counts of each
# (callgrind), and the share of time of each function (perf; may be empty).
#
# The phase of a function is the first whose pattern its name matches.
BEGIN {
    add("camera rays", "^(camera_[^bp]|pixel_jitter|sobol|pixel_ids)")
    add("plain packets: all of it", "^(plain_|plane_section|section_)")
    add("culling", "(_covers|_misses|_misses_to_point|_miss_sphere|_support|_shaft)$|^(support_|shaft_|beam_|camera_beam|camera_packet_beam|intervals_to|packet_intervals|packet_active|linear_cand|occluding_cand|candidates_|shape_set_|set_bvh|set_intervals|bvh_|packet_tr|single_t|tile_is_back|tile_sight|aabb)")
    add("shadow rays: intersection", "(_is_occluding|_occluded)")
    add("rays: intersection", "(_is_hit|_beam_hits|_closest_hits|_intersect|closest_hit|sphere_intersect|mesh_|leaf_|triangle|shape_update_lanes)")
    add("marching", "^(sphere_trace|march_|sdf_|union_run|grid_|repeat_)")
    add("lights: sampling", "(_light_sample|light_sample_|^light_|emitters_)")
    add("shading", "^(shade_|find_|real_pow|phong|textures_|material|sky_|local_|fresnel)")
    add("mirrors and glass: new rays", "^(reflect_|refract_|secondary_|dielectric|contact|interior|wavefront|trace_packet|trace_secondary|losses|shadow_trans|packet_gather|queue|node|glass_rays|neighbours_|segment_|path_nodes|scattered|ray_queue|kept_rays)")
    add("passes and store", "^(trace_|colors_|tile_trace|tile_load|shade_tile|retrace|settle|camera_rays_init|tile_fill)")
    add("encoding", "^(tile_finish|tile_encode|average_row|row_encode|encoder_encode)")
}
function add(name, pattern) { names[++phases] = name; patterns[phases] = pattern }
function phase_of(function_name,    i) {
    if (!(function_name in known)) {
        known[function_name] = 0
        for (i = 1; i <= phases && !known[function_name]; i++)
            if (function_name ~ patterns[i]) known[function_name] = i
    }
    return known[function_name]
}
FNR == 1 { part++ }

# objdump: "  address:<tab>mnemonic operands"; what calculates with numbers is remembered.
part == 1 {
    if ($2 ~ /^v?(add|sub|mul|div|sqrt|min|max|cmp[a-z_]*|u?comi|fn?m(add|sub)[0-9]*)([sp][sd])$/) {
        sub(":", "", $1)
        arithmetic[$1] = 1
    }
    next
}
# callgrind: the line after "calls=" is what the called function took, which is counted there.
part == 2 && /^ob=/ { is_ours = $0 ~ /\/dioptre$/; next }
part == 2 && /^fn=/ { name = substr($0, 4); sub(/\..*|'.*/, "", name); next }
part == 2 && /^calls=/ { getline; next }
part == 2 && /^0x/ {
    if (is_ours && (p = phase_of(name))) {
        count[p] += $3
        if (substr($1, 3) in arithmetic) numbers[p] += $3
    }
    next
}
# perf: "share% function".
part == 3 {
    sub("%", "", $1); sub(/\..*/, "", $NF)
    share[(p = phase_of($NF)) ? p : 0] += $1
    has_time = 1
}
END {
    vectors = rays / lanes
    for (i = 1; i <= phases; i++) {
        if (!count[i]) continue
        printf "| %s | %.0f | %.0f |", names[i], count[i] / vectors, numbers[i] / vectors
        each = share[i] / 100 * ns * lanes
        if (has_time) printf((each < 0.05 ? " |" : " %.1f |"), each)
        print ""
        total += count[i]; total_numbers += numbers[i]; time += share[i]
    }
    printf "| **all of these** | %.0f | %.0f |", total / vectors, total_numbers / vectors
    if (has_time) printf " %.1f |", time / 100 * ns * lanes
    print ""
}
