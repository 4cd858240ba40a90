# SPDX-License-Identifier: MIT
# The conformance image's sources, and what it is to find: the host's hashes, by the same sources.
CONFORMANCE_SOURCES = $(wildcard firmware/conformance/conformance*.c)
CONFORMANCE = $(BUILD)/conformance
CONFORMANCE_EXPECTED = $(CONFORMANCE)/conformance_expected.h
CONFORMANCE_INPUTS = $(CONFORMANCE_SOURCES) $(wildcard firmware/conformance/*.h firmware/ports/bare/*.h)

$(CONFORMANCE_EXPECTED): $(CONFORMANCE)/expected
	@$< >$@.tmp && mv $@.tmp $@

$(CONFORMANCE)/expected: $(CONFORMANCE_INPUTS) firmware/conformance/expected.c $(BUILD)/libglint.a
	@mkdir -p $(@D)
	@$(CC) $(filter-out -MMD -MP,$(LIB_CFLAGS)) -fno-freestanding -Ilib -Ifirmware/conformance -Ifirmware/ports/bare $(filter %.c %.a,$^) $(LDFLAGS) -o $@
