# SPDX-License-Identifier: MIT
icebreaker_TOP = icebreaker
icebreaker_DEVICE = --up5k --package sg48
icebreaker_MHZ = 25.175
