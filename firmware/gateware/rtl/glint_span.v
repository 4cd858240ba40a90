// SPDX-License-Identifier: MIT
// Purpose: the span unit. One prepared span in (struct glint_span), its pixels out in RGB565: those of
// a material with albedo 255 in gamma space, undithered, by the sequence that README.md states.
// Parameters: WHITE, 1 where red's specular coefficient is that of all (two products less); ROWS, 1 where those two are
// made of logic cells, 0 of multiplier blocks; LUT_RAM and ROW_AND as glint_core's.
// Latency: a pixel a clock, the first 19 clocks later; spans follow each other without a gap.
// Reset: synchronous, active high; drops spans and pixels inside.
// Back-pressure: while a pixel waits all stages stand still; s_ready follows m_ready in the same clock
// (glint_skid breaks that path). Registers may change in a clock in which idle is 1 and no span is taken.
`default_nettype none

module glint_span #(
    parameter integer WHITE = 0, // 0 or 1
    parameter integer ROWS = 1, // 0 or 1
    parameter integer LUT_RAM = 0, // 0 or 1
    parameter integer ROW_AND = 0 // 0 or 1
) (
    input wire clk,
    input wire rst,
    // Registers, held still unless idle.
    input wire model,        // 0: MSH, 1: Schlick
    input wire [9:0] n,      // 1..1000
    input wire [16:0] c_min, // glint_cutoff(model, n, q)
    input wire clamp_peak,
    input wire [50:0] ambient, // {red, green, blue}, 17 bits each, 0..65536 = 1.0
    input wire [50:0] diffuse,
    input wire [50:0] specular,
    // Spans.
    input wire s_valid,
    output wire s_ready,
    input wire [31:0] s_t,
    input wire [31:0] s_dt,
    input wire [31:0] s_ddt,
    input wire [31:0] s_nl,
    input wire [31:0] s_dnl,
    input wire [12:0] s_w, // 0..4096
    // Pixels.
    output wire m_valid,
    input wire m_ready,
    output wire [15:0] m_rgb565,
    output wire m_last, // of its span
    output wire idle // no span and no pixel is inside
);
    wire walk_idle, core_idle, shade_idle;
    assign idle = walk_idle & core_idle & shade_idle;

    wire walk_valid, walk_ready, walk_last;
    wire signed [17:0] c;
    wire [16:0] nl;
    glint_walk walk (
        .clk(clk),
        .rst(rst),
        .s_valid(s_valid),
        .s_ready(s_ready),
        .s_t(s_t),
        .s_dt(s_dt),
        .s_ddt(s_ddt),
        .s_nl(s_nl),
        .s_dnl(s_dnl),
        .s_w(s_w),
        .m_valid(walk_valid),
        .m_ready(walk_ready),
        .m_c(c),
        .m_nl(nl),
        .m_last(walk_last),
        .idle(walk_idle)
    );

    wire core_valid, core_ready, core_last;
    wire [16:0] f, core_nl;
    glint_core #(
        .USER(18),
        .LUT_RAM(LUT_RAM),
        .ROW_AND(ROW_AND)
    ) core (
        .clk(clk),
        .rst(rst),
        .model(model),
        .n(n),
        .c_min(c_min),
        .s_valid(walk_valid),
        .s_ready(walk_ready),
        .s_c(c),
        .s_user({walk_last, nl}),
        .m_valid(core_valid),
        .m_ready(core_ready),
        .m_f(f),
        .m_user({core_last, core_nl}),
        .idle(core_idle)
    );

    glint_shade #(
        .WHITE(WHITE),
        .ROWS(ROWS),
        .ROW_AND(ROW_AND)
    ) shade (
        .clk(clk),
        .rst(rst),
        .clamp_peak(clamp_peak),
        .ambient(ambient),
        .diffuse(diffuse),
        .specular(specular),
        .s_valid(core_valid),
        .s_ready(core_ready),
        .s_f(f),
        .s_nl(core_nl),
        .s_last(core_last),
        .m_valid(m_valid),
        .m_ready(m_ready),
        .m_rgb565(m_rgb565),
        .m_last(m_last),
        .idle(shade_idle)
    );

    generate
        if (WHITE < 0 || WHITE > 1 || ROWS < 0 || ROWS > 1 || LUT_RAM < 0 || LUT_RAM > 1 ||
            ROW_AND < 0 || ROW_AND > 1) begin : flags
            WHITE_ROWS_LUT_RAM_and_ROW_AND_must_be_0_or_1 stop ();
        end
    endgenerate
endmodule

`default_nettype wire
