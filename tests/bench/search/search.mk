# SPDX-License-Identifier: MIT
# How the joint search scales over threads and MPI ranks.
bench-search: ## measure: of make bench, how glint search --joint scales over threads and ranks
	@+$(SUBMAKE) setup-unit
	@+$(SUBMAKE) run-bench-search

run-bench-search: $(BUILD)/glint
	@tests/bench/search/search $(BUILD)/glint

.PHONY: bench-search run-bench-search
