# SPDX-License-Identifier: MIT
# make bench-tgx TGX=FOLDER: pictures of the teapot by tgx, from a checkout of github.com/vindar/tgx, of which nothing is kept here, and by glint, on
# QEMU's Cortex-M7 and M33.
BENCH_TGX_PACKAGES = libstdc++-arm-none-eabi-newlib

bench-tgx: ## measure: instructions of a teapot by tgx, with the FPU, beside glint's, into costs.tsv: TGX=FOLDER, a checkout of vindar/tgx
	@test -e '$(TGX)/src/Renderer3D.h' || { echo "make: TGX=$(TGX): is no checkout of tgx: git clone https://github.com/vindar/tgx" >&2; exit 1; }
	@.ci/need "make bench-tgx" $(BENCH_TGX_PACKAGES) $(BENCH_PACKAGES) $(TARGETS_PACKAGES)
	@+$(SUBMAKE) write-tgx

write-tgx: $(BENCH_SCENE)/scene.json $(bare_image_mps2-an500) $(bare_image_mps2-an505) $(BENCH_MESH_INPUTS) $(BOARDS)
	@PYTHONDONTWRITEBYTECODE=1 BENCH_BOARDS="mps2-an500 mps2-an505" COUNT_TGX='$(abspath $(TGX))' \
		tests/targets/test_costs $(BENCH) simulated "$$(git -C '$(TGX)' rev-parse --short=7 HEAD 2>/dev/null || echo unknown)" tgx; worse=$$?; \
		tests/bench/tables write && exit $$worse

.PHONY: bench-tgx write-tgx
