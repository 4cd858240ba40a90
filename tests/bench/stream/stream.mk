# SPDX-License-Identifier: MIT
# make bench-stream: bytes a frame of the measured animations, and the frames/s predicted from them. The last part of make bench.
bench-stream: ## measure: set up what is missing; bytes a frame of moving lights, and the frames/s predicted over USB
	@+$(SUBMAKE) setup-build
	@+$(SUBMAKE) run-bench-stream

run-bench-stream: $(BUILD)/glint
	@mkdir -p $(BENCH)
	@tests/bench/stream/stream $(BUILD)/glint $(BENCH)/stream.json

.PHONY: bench-stream run-bench-stream
