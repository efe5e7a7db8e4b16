# dioptre: a ray tracer to teach with. `make run` opens the box, `make test` tests everything.

VERSION   := 0.1.0
PREFIX    ?= /usr/local
BUILD     ?= build
CC        ?= cc
CXX       ?= c++
OBJCOPY   ?= objcopy
OPTIMIZE  ?= -O3 -g
SANITIZE  ?=
COMMA     := ,
# $(call SAY,WORD,FILE): says in a line what the recipe does; V=1 prints the whole command instead.
SAY       = $(if $(V),,@echo '  $(1)  $(2)' && )

# --- flags ---------------------------------------------------------------------------------------
WARNINGS  := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion -Wmissing-prototypes -Werror
# The same bits on every machine and at every width: no contraction, no fast-math (doc/tour.md).
ARITHMETIC := -ffp-contract=off -fno-math-errno -fno-trapping-math
# SDL's header would bring in Intel's, half a second per file, for CPU queries that nothing here asks.
CPPFLAGS  := -Iinclude -Isrc -DDIOPTRE_VERSION='"$(VERSION)"' -D_GNU_SOURCE -DSDL_DISABLE_IMMINTRIN_H
CFLAGS    = -std=gnu11 $(OPTIMIZE) $(WARNINGS) $(ARITHMETIC) -fPIC -pthread $(HARDENED) $(SANITIZERS) $(COUNTERS)
CXXFLAGS  = -std=c++17 $(OPTIMIZE) -Wall -Wextra -Wpedantic -Wshadow -Werror -fPIC -fvisibility=hidden $(HARDENED) $(SANITIZERS) $(NO_VTABLES) $(COUNTERS)
# What an error would be used for is made hard: stacks that are overwritten are noticed, as are functions
# of the C library that write too far, and the linker's tables are complete and constant before main. Not
# in builds for debugging: the checked functions need the optimiser, and sanitizers have checks of their own.
HARDENED   = $(if $(SANITIZE)$(COVERAGE)$(filter -O0 -O1,$(OPTIMIZE)),,-fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
# Engines and methods, which get no bytes of a file, go without stack protectors: these cost 1.1 % of the
# instructions of scenes/glass-sphere.lua (f32x8, 96 x 72, 4 samples).
UNPROTECTED := -fno-stack-protector
LINK_HARDENED = -Wl,-z,relro,-z,now
# COVERAGE=1: a build that counts which lines run. (No later option takes back --coverage.)
COUNTERS   = $(if $(COVERAGE),-fprofile-arcs -ftest-coverage -fprofile-update=atomic)
UNCOUNTED  = $(if $(COVERAGE),-fno-profile-arcs -fno-test-coverage -O3)
# Counters are written by processes that do not return from main, too, and those of modules by their workers.
COUNTERS_OBJECT = $(if $(COVERAGE),$(OBJ)/tests/coverage/counters.o)
WRAP            = $(if $(COVERAGE),$(addprefix -Wl$(COMMA)--wrap=,$(1)))
COUNTERS_LINK = $(call WRAP,send syscall setrlimit worker_exit_to_retry) $(if $(COVERAGE),-rdynamic)
MODULE_COUNTERS = $(call WRAP,__gcov_init __gcov_exit)
TEST_COUNTERS   = $(call WRAP,_exit worker_exit_to_retry)
SANITIZERS := $(if $(SANITIZE),-fsanitize=$(SANITIZE) -fno-omit-frame-pointer -fno-sanitize-recover=all)
# The check of virtual tables asks the system for pipes, which the filter of workers refuses.
NO_VTABLES := $(if $(findstring undefined,$(SANITIZE)),-fno-sanitize=vptr)
PKG_CFLAGS = $(shell pkg-config --cflags $(1) 2>/dev/null)
PKG_LIBS   = $(shell pkg-config --libs $(1) 2>/dev/null)
# Asked once: a make that installs packages runs a make of its own afterwards.
ROOM_CFLAGS := $(call PKG_CFLAGS,sdl2 lua5.4 cairo)
# $(call NEED,LIBRARY,PACKAGE): stops with the package's name and not with a compiler's error.
NEED = @pkg-config --exists $(1) 2>/dev/null || { \
    echo "$(1) is missing: sudo apt-get install pkg-config $(2), or make run, which does that" >&2; exit 1; }

# --- engines: the objects of src/trace at one number type and width ------------------------------
# An engine is two lines: its name, the preferred first, and its flags.
X86 = $(if $(filter x86_64,$(MACHINE)),$(1))
MACHINE := $(shell uname -m)
ALL_ENGINES  := f32x8
FLAGS_f32x8  := -DREAL_BITS=32 -DLANES=8 $(call X86,-mavx2)
ALL_ENGINES  += f32x16
FLAGS_f32x16 := -DREAL_BITS=32 -DLANES=16 $(call X86,-mavx512vl -mavx512dq -mprefer-vector-width=512)
ALL_ENGINES  += f32x4
FLAGS_f32x4  := -DREAL_BITS=32 -DLANES=4
ALL_ENGINES  += f32x1
# Vectors of two of the three numbers of a point cost more than they save: 2 to 4 % of the box.
FLAGS_f32x1  := -DREAL_BITS=32 -DLANES=1 -fno-tree-slp-vectorize
ALL_ENGINES  += f64x4
FLAGS_f64x4  := -DREAL_BITS=64 -DLANES=4 $(call X86,-mavx2)
ALL_ENGINES  += f64x1
FLAGS_f64x1  := -DREAL_BITS=64 -DLANES=1 -fno-tree-slp-vectorize
ALL_ENGINES  += f128x1
FLAGS_f128x1 := -DREAL_BITS=128 -DLANES=1
# Fewer build faster: make ENGINES="f32x8 f64x1 f128x1"
ENGINES      ?= $(ALL_ENGINES)

# --- number types: the objects of src/lab/methods at one of them ------------------------------------
TYPE_float    := -DREAL_BITS=32
TYPE_double   := -DREAL_BITS=64
TYPE_extended := -DREAL_BITS=80
TYPE_quad     := -DREAL_BITS=128
TYPES := float double extended quad

# --- sources -------------------------------------------------------------------------------------
TRACE_SOURCES := $(filter-out src/trace/all.c,$(wildcard src/trace/*.c src/trace/*/*.c))
MODULE_SOURCES := $(wildcard src/assets/*_plugin.c src/assets/*/*_plugin.c)
METHOD_SOURCES := $(filter-out src/lab/methods/all.c,$(wildcard src/lab/methods/*.c))
ROOM_SOURCES  := $(filter-out $(MODULE_SOURCES) src/lab/methods/%,$(foreach room,base scene render script assets view lab,$(wildcard src/$(room)/*.c src/$(room)/*/*.c)))
CLI_SOURCES   := $(wildcard src/cli/*.c)
OBJ           := $(BUILD)/obj
ENGINE_OBJECTS := $(ENGINES:%=$(OBJ)/engine-%.o)
TYPE_OBJECTS  := $(TYPES:%=$(OBJ)/type-%.o)
GUI_OBJECTS   := $(patsubst %.cpp,$(OBJ)/%.o,$(wildcard src/view/gui/*.cpp))
ROOM_OBJECTS  := $(ROOM_SOURCES:%.c=$(OBJ)/%.o) $(GUI_OBJECTS) $(ENGINE_OBJECTS) $(TYPE_OBJECTS)
CLI_OBJECTS   := $(CLI_SOURCES:%.c=$(OBJ)/%.o)
TEST_SOURCES  := $(wildcard tests/test_*.c)
TESTS         := $(TEST_SOURCES:tests/%.c=$(BUILD)/tests/%)
PROGRAM       := $(BUILD)/dioptre
FLAGS         := $(BUILD)/flags
IMAGES_MODULE := $(BUILD)/dioptre-images.so
MESHES_MODULE := $(BUILD)/dioptre-meshes.so
MODULES       := $(IMAGES_MODULE) $(MESHES_MODULE)
LANGUAGES     := $(patsubst src/po/%.po,%,$(wildcard src/po/*.po))
CATALOGUES    := $(LANGUAGES:%=$(BUILD)/locale/%/LC_MESSAGES/dioptre.mo)
# The interface is C++ (src/view/gui), for Dear ImGui.
LIBRARIES     = $(call PKG_LIBS,sdl2 lua5.4 cairo imgui) -ldl -lm -lstdc++ -pthread
# The program that reads scenes, pictures and models: src/worker/main.c.
WORKER         := $(BUILD)/dioptre-worker
WORKER_SOURCES := $(wildcard src/worker/*.c) $(filter src/base/% src/scene/% src/script/% src/assets/%,$(ROOM_SOURCES))
WORKER_OBJECTS := $(WORKER_SOURCES:%.c=$(OBJ)/%.o) $(COUNTERS_OBJECT)

.DEFAULT_GOAL := all
.DELETE_ON_ERROR:
.PHONY: all
all: $(PROGRAM) $(WORKER) $(MODULES) $(CATALOGUES)

$(PROGRAM): $(CLI_OBJECTS) $(ROOM_OBJECTS) $(COUNTERS_OBJECT)
	$(call SAY,cc,$@)$(CC) $(CFLAGS) $(LINK_HARDENED) -pie $(COUNTERS_LINK) -o $@ $^ $(LIBRARIES)

$(WORKER): $(WORKER_OBJECTS)
	$(call SAY,cc,$@)$(CC) $(CFLAGS) $(LINK_HARDENED) -pie $(COUNTERS_LINK) -o $@ $^ $(call PKG_LIBS,lua5.4) -ldl -lm -pthread

$(IMAGES_MODULE): src/assets/images/image_plugin.cpp src/assets/images/image_plugin.h $(FLAGS)
	$(call NEED,OpenImageIO,libopenimageio-dev)
	@mkdir -p $(@D)
	$(call SAY,c++,$@)$(CXX) $(CPPFLAGS) $(CXXFLAGS) $(call PKG_CFLAGS,OpenImageIO) $(LINK_HARDENED) $(MODULE_COUNTERS) -shared -o $@ $< $(call PKG_LIBS,OpenImageIO)

$(MESHES_MODULE): src/assets/meshes/mesh_plugin.c src/assets/meshes/mesh_plugin.h $(FLAGS)
	$(call NEED,assimp,libassimp-dev)
	@mkdir -p $(@D)
	$(call SAY,cc,$@)$(CC) $(CPPFLAGS) $(CFLAGS) -fvisibility=hidden $(call PKG_CFLAGS,assimp) $(LINK_HARDENED) $(MODULE_COUNTERS) -shared -o $@ $< $(call PKG_LIBS,assimp)

$(BUILD)/locale/%/LC_MESSAGES/dioptre.mo: src/po/%.po
	@command -v msgfmt >/dev/null || { \
	    echo "msgfmt is missing: sudo apt-get install gettext, or make run, which does that" >&2; exit 1; }
	@mkdir -p $(@D)
	$(call SAY,msgfmt,$@)msgfmt --check -o $@ $<

.PHONY: libraries
libraries:
	$(call NEED,sdl2,libsdl2-dev)
	$(call NEED,lua5.4,liblua5.4-dev)
	$(call NEED,cairo,libcairo2-dev)
	$(call NEED,imgui,libimgui-dev)

# Other flags than last time make everything anew.
FLAGS_NOW := $(CC) $(CXX) $(CPPFLAGS) $(CFLAGS) $(CXXFLAGS) $(ROOM_CFLAGS) $(foreach engine,$(ENGINES),$(FLAGS_$(engine)))
.PHONY: always
always:
$(FLAGS): always
	@mkdir -p $(@D)
	@echo '$(subst ','\'',$(FLAGS_NOW))' | cmp -s - $@ || echo '$(subst ','\'',$(FLAGS_NOW))' >$@

$(OBJ)/%.o: %.c $(FLAGS) | libraries
	@mkdir -p $(@D)
	$(call SAY,cc,$@)$(CC) $(CPPFLAGS) $(CFLAGS) $(ROOM_CFLAGS) -MMD -MP -c -o $@ $<
$(GUI_OBJECTS): $(OBJ)/%.o: %.cpp $(FLAGS) | libraries
	@mkdir -p $(@D)
	$(call SAY,c++,$@)$(CXX) $(CPPFLAGS) $(filter-out -fvisibility=hidden,$(CXXFLAGS)) $(patsubst -I%,-isystem %,$(call PKG_CFLAGS,sdl2 imgui)) -MMD -MP -c -o $@ $<
# gcc 12 for ARM64 breaks down when it makes vectors of the loops of this room.
$(OBJ)/src/render/z_fighting/%.o: CFLAGS += $(if $(filter aarch64,$(MACHINE)),-fno-tree-vectorize)
$(OBJ)/src/render/engines.o: CPPFLAGS += '-DENGINE_LIST(X)=$(foreach engine,$(ENGINES),X($(engine)))'


# One relocatable object per engine, with one symbol: everything else in it becomes local. The
# compiler sees all of src/trace as one file; SPLIT=1 compiles file by file, for who edits there.
# $(call KEEP,SYMBOL): links $^ into $@.
KEEP = $(call SAY,ld,$@)$(LD) -r -o $@.all $(filter %.o,$^) && $(OBJCOPY) --keep-global-symbol=$(1) $@.all $@ && rm -f $@.all
# $(eval $(call ONE_SYMBOL,OBJECT,FOLDER,SOURCES,FLAGS,SYMBOL))
define ONE_SYMBOL
$(OBJ)/$(1)/%.o: $(2)/%.c $(FLAGS)
	@mkdir -p $$(@D)
	$$(call SAY,cc,$$@)$$(CC) $$(CPPFLAGS) $$(CFLAGS) $$(UNCOUNTED) $$(UNPROTECTED) $(4) -MMD -MP -c -o $$@ $$<
$(OBJ)/$(1).o: $(if $(SPLIT),$(3:$(2)/%.c=$(OBJ)/$(1)/%.o),$(OBJ)/$(1)/all.o)
	$$(call KEEP,$(5))
endef
$(foreach engine,$(ENGINES),$(eval $(call ONE_SYMBOL,engine-$(engine),src/trace,$(TRACE_SOURCES),\
    -Wno-psabi $$(FLAGS_$(engine)) -DENGINE=engine_$(engine) -DENGINE_NAME='"$(engine)"',engine_$(engine))))
# The same for the laboratory's methods: one symbol per number type.
$(foreach type,$(TYPES),$(eval $(call ONE_SYMBOL,type-$(type),src/lab/methods,$(METHOD_SOURCES),\
    $$(TYPE_$(type)) -DLANES=1 -DNUMBER_TYPE=number_$(type) -DNUMBER_TYPE_NAME='"$(subst extended,long double,$(type))"',number_$(type))))
# Experiments mix double with quad on purpose: what they widen is exact.
$(OBJ)/src/lab/%.o: CFLAGS += -Wno-double-promotion
# Its tables say how they came about.
$(OBJ)/src/lab/charts/csv.o: CPPFLAGS += -DDIOPTRE_FLAGS='"$(OPTIMIZE) $(ARITHMETIC)"'

-include $(shell find $(OBJ) -name '*.d' 2>/dev/null)

# --- packages: what a bare Debian 12 with gcc and make lacks --------------------------------------
RUN_PACKAGES  := g++ pkg-config gettext libsdl2-dev liblua5.4-dev libcairo2-dev libimgui-dev libopenimageio-dev libassimp-dev fonts-dejavu-core
TEST_PACKAGES := libcmocka-dev clang libclang-rt-14-dev xvfb xauth xdotool x11-xkb-utils xkb-data \
                 imagemagick openbox qemu-user doxygen graphviz ffmpeg parallel slurm-wlm munge gnuplot-nox \
                 desktop-file-utils appstream shared-mime-info libglib2.0-bin gappa libflint-arb-dev \
                 valgrind binutils libembree-dev libgl-dev
COVERAGE_PACKAGES := gcovr
BENCH_PACKAGES := gnuplot-nox valgrind binutils
PEER_PACKAGES := povray tachyon libembree-dev libgl-dev libgl1-mesa-dri xvfb xauth
WEB_PACKAGES  := patch emscripten clang-14 clang-19 llvm-19 dpkg-dev libstb-dev rapidjson-dev libutfcpp-dev linux-libc-dev gettext fonts-dejavu-core fonttools
WEB_LIBRARY_SOURCES := libsdl2 lua5.4 libjpeg-turbo imgui cairo pixman assimp
LINT_PACKAGES := clang-format clang-tidy cppcheck

.PHONY: packages test-packages
packages:
	@.ci/packages $(RUN_PACKAGES)
test-packages:
	@.ci/packages $(RUN_PACKAGES) $(TEST_PACKAGES)

# --- run -----------------------------------------------------------------------------------------
# pkg-config may come with the packages only: what needs its answers runs in a make of its own.
.PHONY: run
run: packages
	@$(MAKE) --no-print-directory -j$$(nproc) all
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ]; then \
	    exec $(PROGRAM) view scenes/box.lua; \
	else \
	    $(PROGRAM) render scenes/box.lua -o box.bmp && \
	    echo "There is no display: the box is in box.bmp."; \
	fi

# --- the page ------------------------------------------------------------------------------------
# The program for a browser, in build/web. What is fetched and compiled is kept in build/web-work.
.PHONY: web test-web bench-web
web:
	@.ci/packages $(WEB_PACKAGES)
	@command -v npm >/dev/null || .ci/packages npm
	@.ci/sources build/web-work/sources $(WEB_LIBRARY_SOURCES)
	@$(MAKE) --no-print-directory -j$$(nproc) -f src/web/Makefile page
# In real browsers, against the pictures of the desktop's program.
test-web: web packages
	@.ci/packages chromium firefox-esr
	@$(MAKE) --no-print-directory -j$$(nproc) all
	@$(MAKE) --no-print-directory -f src/web/Makefile test-page
# The page's speed, for doc/web.md. On a quiet machine: it takes a quarter of an hour.
bench-web: web packages
	@.ci/packages chromium
	@$(MAKE) --no-print-directory -j$$(nproc) all
	@$(MAKE) --no-print-directory -f src/web/Makefile bench-page
	@doc/figures.sh

# --- other builds --------------------------------------------------------------------------------
# With the engines that tests ask them for: of each number type and width one.
ASAN_BUILD  := BUILD=build/asan OPTIMIZE='-O1 -g' SANITIZE=address,undefined ENGINES='f32x8 f32x4 f32x1 f64x1 f128x1'
CLANG_BUILD := BUILD=build/clang CC=clang CXX=clang++ ENGINES='f32x16 f32x4 f64x1'
TSAN_BUILD  := BUILD=build/tsan OPTIMIZE='-O1 -g' SANITIZE=thread ENGINES='f32x8 f64x1 f128x1'
# What reads strangers' bytes, with clang's fuzzer; nothing of it is traced, so it has no engine.
FUZZ_BUILD  := BUILD=build/fuzz CC=clang CXX=clang++ OPTIMIZE='-O1 -g' SANITIZE=fuzzer-no-link,address,undefined,float-cast-overflow ENGINES=
# Counts which lines and branches run; those of the engines are not counted, which are as fast as ever.
COVERAGE_BUILD := BUILD=build/coverage OPTIMIZE='-O1 -g' COVERAGE=1
.PHONY: asan tsan clang
asan:
	@$(MAKE) --no-print-directory $(ASAN_BUILD) all
# The worker is that of the release: it has one thread, and its filter of system calls refuses what the
# thread sanitizer asks for.
tsan:
	@$(MAKE) --no-print-directory all
	@$(MAKE) --no-print-directory -j2 $(TSAN_BUILD) build/tsan/dioptre
	@ln -sf ../dioptre-worker build/tsan/dioptre-worker
clang:
	@$(MAKE) --no-print-directory $(CLANG_BUILD) all

# --- tests ---------------------------------------------------------------------------------------
# All rooms, once, for all test programs.
ROOMS         := $(BUILD)/tests/librooms.so
$(ROOMS): $(ROOM_OBJECTS) $(COUNTERS_OBJECT)
	@mkdir -p $(@D)
	$(call SAY,cc,$@)$(CC) $(CFLAGS) $(COUNTERS_LINK) -shared -o $@ $^ $(LIBRARIES)
WITH_ROOMS    := -L$(BUILD)/tests -lrooms -Wl,-rpath,'$$ORIGIN:$$ORIGIN/..:$$ORIGIN/tests'
# A program looks for its worker beside itself. One rule makes each link: test programs are made in parallel.
WORKER_LINKS  := $(addsuffix /dioptre-worker,$(BUILD)/tests $(BUILD)/tests/bench)
$(WORKER_LINKS): $(WORKER)
	@mkdir -p $(@D)
	@ln -sfr $< $@
$(BUILD)/tests/%: tests/%.c $(wildcard tests/*.h) $(ROOMS) | $(WORKER_LINKS)
	@mkdir -p $(@D)
	$(call SAY,cc,$@)$(CC) $(CPPFLAGS) $(CFLAGS) $(call PKG_CFLAGS,cmocka) $(ROOM_CFLAGS) -Itests $(UNCOUNTED) $(TEST_COUNTERS) -o $@ $< $(WITH_ROOMS) $(LIBRARIES) $(call PKG_LIBS,cmocka)
# Parts of an engine, checked at each number type and width: one object per engine, with one symbol.
# $(eval $(call ENGINE_CHECKS,NAME)): the objects of tests/NAME/NAME.c are linked into tests/test_NAME.
define ENGINE_CHECKS
$(ENGINES:%=$(OBJ)/tests/$(1)/%.o): $(OBJ)/tests/$(1)/%.o: tests/$(1)/$(1).c $(FLAGS)
	@mkdir -p $$(@D)
	$$(call SAY,cc,$$@)$$(CC) $$(CPPFLAGS) $$(CFLAGS) $$(UNCOUNTED) -Wno-psabi $$(FLAGS_$$*) -DCHECKS=$(1)_$$* -MMD -MP -MF $$(@:.o=.d) -MT $$@ \
	    -c -o $$@.all $$< && $$(OBJCOPY) --keep-global-symbol=$(1)_$$* $$@.all $$@ && rm -f $$@.all
$(BUILD)/tests/test_$(1): tests/test_$(1).c $(ENGINES:%=$(OBJ)/tests/$(1)/%.o)
$(BUILD)/tests/test_$(1): private CPPFLAGS += '-DENGINE_LIST(X)=$(foreach engine,$(ENGINES),X($(engine)))'
$(BUILD)/tests/test_$(1): private WITH_ROOMS := $(ENGINES:%=$(OBJ)/tests/$(1)/%.o) $$(WITH_ROOMS)
endef
$(foreach name,box_tests compaction shafts tape_octree,$(eval $(call ENGINE_CHECKS,$(name))))
# Ball arithmetic, which judges the laboratory's reference.
$(BUILD)/tests/test_arb: private LIBRARIES += -lflint-arb -lflint

# The shares of lines and branches that tests reach: tests/coverage.sh has their floors and the tests that count.
.PHONY: coverage
coverage: test-packages
	@.ci/packages $(COVERAGE_PACKAGES)
	@$(MAKE) --no-print-directory -j2 all clang
	@$(MAKE) --no-print-directory -j2 $(COVERAGE_BUILD) all tests
	@tests/coverage.sh

# What `make bench` and `make peers` run.
BENCH_PROGRAMS := $(addprefix $(BUILD)/tests/bench/,tree marching march-steps) $(addprefix $(BUILD)/bench-,needs acne schedule)
PEER_PROGRAMS  := $(addprefix $(BUILD)/peer-,embree accuracy fragment)
.PHONY: test tests
test: test-packages
	@$(MAKE) --no-print-directory -j2 all tests $(BENCH_PROGRAMS) $(PEER_PROGRAMS)
	@$(MAKE) --no-print-directory -j2 $(ASAN_BUILD) all tests
	@$(MAKE) --no-print-directory -j2 clang
	@$(MAKE) --no-print-directory -j2 $(FUZZ_BUILD) fuzzers
	@$(MAKE) --no-print-directory tsan
	@tests/run.sh

tests: $(TESTS) $(BUILD)/tests/faults.so $(BUILD)/tests/spd_hits $(BUILD)/tests/picture_probe $(CATALOGUES)

# Makes calls to the system fail; never linked, but preloaded.
$(BUILD)/tests/faults.so: tests/faults/faults.c $(FLAGS)
	@mkdir -p $(@D)
	$(call SAY,cc,$@)$(CC) -std=gnu11 -O1 -g -Wall -Wextra -Werror -fPIC -shared -o $@ $<

# Each call to the system fails once: all of them, which takes a quarter of an hour.
.PHONY: faults
faults: test-packages
	@$(MAKE) --no-print-directory all $(BUILD)/tests/faults.so
	@FAULTS=0 tests/faults.sh

# --- ARM64 ---------------------------------------------------------------------------------------
# Compiled for another processor, and run in an emulator: all but the window and the modules, whose
# libraries are here for this processor only. Their headers serve; what is not linked is not called.
CROSS_PACKAGES := gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user dpkg-dev
CROSS_SOURCES  := build/cross-sources
CROSS_BUILD    := BUILD=build/cross MACHINE=aarch64 LD=aarch64-linux-gnu-ld OBJCOPY=aarch64-linux-gnu-objcopy \
    CC='aarch64-linux-gnu-gcc -idirafter /usr/include -idirafter /usr/include/$(MACHINE)-linux-gnu' ENGINES='f32x4 f64x1 f128x1'
# Unit tests that neither start a worker nor need a module or SDL.
CROSS_TESTS    := obj_reader quad text triangulate worker_filter
# Lua, and what the unit tests are written with.
CROSS_LUA      := $(filter-out %/lua.c %/luac.c,$(wildcard $(CROSS_SOURCES)/lua5.4/src/*.c))
CROSS_CMOCKA   := $(CROSS_SOURCES)/cmocka/src/cmocka.c
CMOCKA_FLAGS   := -I$(CROSS_SOURCES)/cmocka/include $(addprefix -DHAVE_,GCC_THREAD_LOCAL_STORAGE SIGNAL_H STRINGS_H \
    STRUCT_TIMESPEC CLOCK_GETTIME STDINT_H INTTYPES_H UNISTD_H SYS_TYPES_H STDLIB_H MALLOC_H SNPRINTF VSNPRINTF STRSIGNAL \
    SYS_STAT_H STDIO_H STRING_H MEMORY_H TIME_H ASSERT_H)
CROSS_LINK     = $(call SAY,cc,$@)$(CC) $(CFLAGS) -static -Wl,--no-warnings,--unresolved-symbols=ignore-all
CROSS_ROOMS    := $(filter-out $(GUI_OBJECTS),$(ROOM_OBJECTS)) $(CROSS_LUA:%.c=$(OBJ)/%.o)
CROSS_PROGRAMS := $(BUILD)/dioptre-emulated $(BUILD)/dioptre-worker-emulated $(CROSS_TESTS:%=$(BUILD)/emulated/test_%)
$(OBJ)/$(CROSS_SOURCES)/%.o: $(CROSS_SOURCES)/%.c $(FLAGS)
	@mkdir -p $(@D)
	$(call SAY,cc,$@)$(CC) -O2 -D_GNU_SOURCE -DLUA_COMPAT_5_3 -DLUA_USE_POSIX $(CMOCKA_FLAGS) -c -o $@ $<
$(BUILD)/dioptre-emulated: $(CLI_OBJECTS) $(CROSS_ROOMS)
	$(CROSS_LINK) -o $@ $^ -lm
$(BUILD)/dioptre-worker-emulated: $(WORKER_OBJECTS) $(CROSS_LUA:%.c=$(OBJ)/%.o)
	$(CROSS_LINK) -o $@ $^ -lm
$(BUILD)/emulated/%: $(OBJ)/tests/%.o $(CROSS_ROOMS) $(CROSS_CMOCKA:%.c=$(OBJ)/%.o)
	@mkdir -p $(@D)
	$(CROSS_LINK) -o $@ $^ -lm
$(CROSS_TESTS:%=$(OBJ)/tests/test_%.o): CPPFLAGS += -Itests -I$(CROSS_SOURCES)/cmocka/include
.SECONDARY: $(CROSS_CMOCKA:%.c=$(OBJ)/%.o) $(CROSS_TESTS:%=$(OBJ)/tests/test_%.o)
.PHONY: cross cross-programs
cross-programs: $(CROSS_PROGRAMS)
cross: packages
	@.ci/packages $(CROSS_PACKAGES)
	@.ci/sources $(CROSS_SOURCES) lua5.4 cmocka
	@$(MAKE) --no-print-directory all
	@$(MAKE) --no-print-directory $(CROSS_BUILD) cross-programs
	@tests/cross.sh

# --- fuzzing -------------------------------------------------------------------------------------
# Each file of tests/fuzz is a target.
FUZZ_TARGETS := $(patsubst tests/fuzz/%.c,%,$(wildcard tests/fuzz/*.c))
FUZZERS      := $(FUZZ_TARGETS:%=$(BUILD)/fuzzers/%)
FUZZ_OBJECTS := $(filter-out $(OBJ)/src/worker/%,$(WORKER_OBJECTS)) \
                $(addprefix $(OBJ)/src/,cli/options.o cli/frames.o render/report_methods.o)
FUZZ_LIBRARY := $(BUILD)/librooms.a
$(FUZZ_LIBRARY): $(FUZZ_OBJECTS)
	$(call SAY,ar,$@)rm -f $@ && ar rcs $@ $^
$(OBJ)/tests/%.o: CPPFLAGS += -Itests/fuzz
# What a target replaces in the rooms, and what it shares with others.
FUZZ_WRAPS    = $(addprefix -Wl$(COMMA)--wrap=,$(WRAPS))
SCRIPT_WRAPS  := lua_newstate lua_sethook worker_enter_sandbox worker_job_ask
WORKER_WRAPS  := worker_process_call worker_process_call_once
$(addprefix $(BUILD)/fuzzers/,scene lesson nff): WRAPS := $(SCRIPT_WRAPS)
$(addprefix $(BUILD)/fuzzers/,scene lesson nff): $(OBJ)/tests/fuzz/shared/script_target.o
$(addprefix $(BUILD)/fuzzers/,texture mesh): WRAPS := $(WORKER_WRAPS)
$(addprefix $(BUILD)/fuzzers/,texture mesh): $(OBJ)/tests/fuzz/shared/handover.o
$(BUILD)/fuzzers/block: WRAPS := $(SCRIPT_WRAPS) $(WORKER_WRAPS) scene_create
$(BUILD)/fuzzers/block: $(OBJ)/tests/fuzz/shared/script_target.o $(OBJ)/tests/fuzz/shared/handover.o
$(BUILD)/fuzzers/reply: WRAPS := posix_spawn posix_spawn_file_actions_adddup2 kill waitpid
$(BUILD)/fuzzers/%: $(OBJ)/tests/fuzz/%.o $(FUZZ_LIBRARY)
	@mkdir -p $(@D)
	$(call SAY,cc,$@)$(CC) $(CFLAGS) -fsanitize=fuzzer $(FUZZ_WRAPS) -o $@ $(filter %.o,$^) $(FUZZ_LIBRARY) $(call PKG_LIBS,lua5.4) -ldl -lm -pthread
.SECONDARY: $(FUZZ_TARGETS:%=$(OBJ)/tests/fuzz/%.o)
.PHONY: fuzzers fuzz
fuzzers: $(FUZZERS)

# A minute, or FUZZ_SECONDS, of random input for all that reads strangers' bytes.
fuzz: test-packages
	@$(MAKE) --no-print-directory all
	@$(MAKE) --no-print-directory $(FUZZ_BUILD) fuzzers
	@FUZZ_SECONDS=$(FUZZ_SECONDS) tests/fuzz.sh

# Half an hour of random keys in the window, with the sanitizers on.
.PHONY: soak
soak: test-packages asan
	BUILD=build/asan SOAK_SECONDS=$(or $(SOAK_SECONDS),1800) tests/soak.sh

# --- measuring -----------------------------------------------------------------------------------
# Compiler and flags, for the files.
MADE_WITH = $(shell $(CC) --version | head -1); $(OPTIMIZE) $(ARITHMETIC)
.PHONY: bench peers
bench: packages
	@.ci/packages $(BENCH_PACKAGES)
	@$(MAKE) --no-print-directory all $(BENCH_PROGRAMS)
	@BUILD=$(BUILD) MADE_WITH='$(MADE_WITH)' tests/bench.sh
	@BUILD=$(BUILD) MADE_WITH='$(MADE_WITH)' tests/bench/profile.sh
	@BUILD=$(BUILD) MADE_WITH='$(MADE_WITH)' tests/bench/acne.sh
	@BUILD=$(BUILD) MADE_WITH='$(MADE_WITH)' tests/bench/run.sh
	@doc/figures.sh
peers: packages
	@.ci/packages $(PEER_PACKAGES)
	@$(MAKE) --no-print-directory all $(PEER_PROGRAMS)
	@status=0; for script in run embree accuracy fragment; do \
	    BUILD=$(BUILD) MADE_WITH='$(MADE_WITH)' tests/peers/$$script.sh || status=1; done; \
	    doc/figures.sh && exit $$status

# Beside the modules, so that it finds them.
$(BUILD)/peer-embree: tests/peers/embree.c $(ROOMS)
	$(call SAY,cc,$@)$(CC) $(CPPFLAGS) $(CFLAGS) -o $@ $< $(WITH_ROOMS) $(LIBRARIES) -lembree3
$(BUILD)/peer-accuracy: tests/peers/accuracy.c $(wildcard tests/*.h) $(ROOMS)
	$(call SAY,cc,$@)$(CC) $(CPPFLAGS) $(CFLAGS) -Itests -o $@ $< $(WITH_ROOMS) $(LIBRARIES) -lembree3 $(call PKG_LIBS,cmocka)

$(BUILD)/peer-fragment: tests/peers/fragment.c
	$(call SAY,cc,$@)$(CC) $(CPPFLAGS) $(CFLAGS) $(call PKG_CFLAGS,sdl2) -o $@ $< $(call PKG_LIBS,sdl2) -lGL

# --- the laboratory ------------------------------------------------------------------------------
# Beside the modules, so that it finds them.
$(BUILD)/bench-%: tests/bench/%.c $(ROOMS)
	$(call SAY,cc,$@)$(CC) $(CPPFLAGS) $(CFLAGS) -o $@ $< $(WITH_ROOMS) $(LIBRARIES)
CHARTED := $(addprefix scenes/,$(addsuffix .lua,box glass-sphere mandelbulb figure-16))
.PHONY: charts
charts: packages
	@.ci/packages $(BENCH_PACKAGES)
	@$(MAKE) --no-print-directory all $(BENCH_PROGRAMS)
	@mkdir -p $(BUILD)/lab
	$(PROGRAM) lab --out doc/lab >$(BUILD)/lab/tables.txt
	$(PROGRAM) chart --kernels --out doc/lab >$(BUILD)/lab/kernels.txt
	$(PROGRAM) chart $(CHARTED) -s 320x240 --samples 4 --out doc/charts >$(BUILD)/lab/charts.txt
	@BUILD=$(BUILD) doc/reports.sh --pictures
	@BUILD=$(BUILD) doc/needs.sh

# --- documentation -------------------------------------------------------------------------------
.PHONY: doc
doc:
	@.ci/packages doxygen graphviz
	@$(MAKE) --no-print-directory $(BUILD)/doc/uml.svg
	@doxygen Doxyfile
	@echo "build/doc/html/index.html"

$(BUILD)/doc/uml.svg: doc/uml.dot
	@mkdir -p $(@D)
	dot -Tsvg -o $@ $<

# --- languages -----------------------------------------------------------------------------------
# The words of the source, and of each translation: which are new, which are gone.
WORD_SOURCES = $(sort $(shell find include src -name '*.[ch]' -o -name '*.cpp'))
PO           ?= src/po
# Functions that look their words up, and which of their arguments holds them.
LOOKING_UP   := error_set:3 error_prefix:2 lua_error_tr:2 app_set_status:2 title_add:2 append_format:2
.PHONY: pot
pot:
	@.ci/packages gettext
	@xgettext --from-code=UTF-8 --keyword=N_ --keyword=NC_:1c,2 $(LOOKING_UP:%=--keyword=%) $(LOOKING_UP:%=--flag=%:c-format) \
	    --add-location=file --package-name=dioptre --package-version=$(VERSION) -o $(PO)/dioptre.pot.new $(WORD_SOURCES)
	@sed -i '/^"POT-Creation-Date/d; s/charset=CHARSET/charset=UTF-8/' $(PO)/dioptre.pot.new
	@mv $(PO)/dioptre.pot.new $(PO)/dioptre.pot
	@for po in $(PO)/*.po; do \
	    msgmerge --quiet --update --backup=none --no-fuzzy-matching --add-location=file $$po $(PO)/dioptre.pot || exit 1; \
	done

# --- gallery -------------------------------------------------------------------------------------
# The page of all scenes, and the pictures of the window that the READMEs show.
.PHONY: gallery
gallery: packages
	@.ci/packages imagemagick xdotool xvfb
	@$(MAKE) --no-print-directory all
	@BUILD=$(BUILD) doc/gallery.sh
	@echo doc/gallery.md
	@BUILD=$(BUILD) doc/window.sh

# --- style ---------------------------------------------------------------------------------------
C_FILES := $(shell find include src tests -name '*.[ch]' -o -name '*.cpp')
.PHONY: format lint
format:
	clang-format -i $(C_FILES)
lint:
	@.ci/packages $(LINT_PACKAGES)
	clang-format --dry-run -Werror $(C_FILES)
	cppcheck --quiet --error-exitcode=1 --std=c11 --enable=warning,portability --inline-suppr \
	    --suppress=missingIncludeSystem -Iinclude -Isrc -DREAL_BITS=32 -DLANES=1 \
	    -DENGINE=engine -DENGINE_NAME='"f32x1"' src
	@tests/style.sh

# --- installing ----------------------------------------------------------------------------------
# What a desktop knows of the program: its entry, icon, type of files and completion.
APP           := org.dioptre.Dioptre
SHARE         = $(DESTDIR)$(PREFIX)/share
.PHONY: install
install: all
	install -D -m 755 $(PROGRAM) $(DESTDIR)$(PREFIX)/bin/dioptre
	for module in $(WORKER) $(MODULES); do \
	    install -D -m 755 $$module $(DESTDIR)$(PREFIX)/lib/dioptre/$${module##*/} || exit 1; \
	done
	install -D -m 644 doc/dioptre.1 $(SHARE)/man/man1/dioptre.1
	for language in $(LANGUAGES); do \
	    install -D -m 644 $(BUILD)/locale/$$language/LC_MESSAGES/dioptre.mo \
	        $(SHARE)/locale/$$language/LC_MESSAGES/dioptre.mo && \
	    install -D -m 644 doc/dioptre.$$language.1 $(SHARE)/man/$$language/man1/dioptre.1 || exit 1; \
	done
	for file in scenes/*.lua scenes/lessons/* scenes/models/* scenes/pictures/*; do \
	    install -D -m 644 $$file $(SHARE)/dioptre/$$file || exit 1; \
	done
	install -D -m 644 src/desktop/$(APP).desktop $(SHARE)/applications/$(APP).desktop
	install -D -m 644 src/desktop/$(APP).svg $(SHARE)/icons/hicolor/scalable/apps/$(APP).svg
	install -D -m 644 src/desktop/$(APP).metainfo.xml $(SHARE)/metainfo/$(APP).metainfo.xml
	install -D -m 644 src/desktop/$(APP).xml $(SHARE)/mime/packages/$(APP).xml
	install -D -m 644 src/desktop/dioptre.bash $(SHARE)/bash-completion/completions/dioptre
	# A package does this for itself; whoever installs by hand has nobody else to do it.
	[ -n "$(DESTDIR)" ] || ! command -v update-mime-database >/dev/null || \
	    update-mime-database $(PREFIX)/share/mime
	[ -n "$(DESTDIR)" ] || ! command -v update-desktop-database >/dev/null || \
	    update-desktop-database -q $(PREFIX)/share/applications

# --- the rest ------------------------------------------------------------------------------------
.PHONY: clean
clean:
	rm -rf build
