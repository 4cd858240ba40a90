// SPDX-License-Identifier: MIT
// Purpose: the span unit behind Wishbone B4 registers (registers/README.md; registers/glint_span_unit.h for C), 32 bits
// wide, for classic and pipelined masters. Pixels leave on a stream.
// Parameters: WHITE, ROWS, LUT_RAM, ROW_AND as glint_span's; SKID, 1 for a glint_skid behind the unit.
// Latency: a request ends a clock after it is taken, one every two clocks; a span's first pixel comes 20 clocks after
// the clock that takes its w (SKID: 21). Reset: synchronous, active high; registers are 0, spans and pixels are
// dropped. Back-pressure: wb_stall is 1 in the clock of an end. A write ends with wb_err, and changes nothing, where
// its register may not change now (a shader's unless idle, a span's while one waits), is read-only or not there,
// where it has less than 32 bits, and where w is too large. While m_ready is 0 pixels wait; the bus never does.
`default_nettype none

module glint_span_wb #(
    parameter integer WHITE = 0, // 0 or 1
    parameter integer ROWS = 1, // 0 or 1
    parameter integer LUT_RAM = 0, // 0 or 1
    parameter integer ROW_AND = 0, // 0 or 1
    parameter integer SKID = 0 // 0 or 1
) (
    input wire clk,
    input wire rst,
    input wire wb_cyc,
    input wire wb_stb,
    input wire wb_we,
    input wire [6:2] wb_adr, // a register
    input wire [3:0] wb_sel,
    input wire [31:0] wb_dat_w, // from the master
    output reg [31:0] wb_dat_r,
    output reg wb_ack,
    output reg wb_err,
    output wire wb_stall,
    output wire m_valid,
    input wire m_ready,
    output wire [15:0] m_rgb565,
    output wire m_last, // of its span
    output wire idle // no span and no pixel is inside
);
    wire model, clamp_peak;
    wire [9:0] n;
    wire [16:0] c_min;
    wire [16:0] ambient_red, ambient_green, ambient_blue, diffuse_red, diffuse_green, diffuse_blue;
    wire [16:0] specular_red, specular_green, specular_blue;
    wire [31:0] t, dt, ddt, nl, dnl, read;
    wire [12:0] w;

    // A request is taken in its first clock, and ends in the next.
    reg waits; // a span is in the registers and offered to the unit
    wire unit_idle, of_shader, of_span, pushes, refused;
    wire taken = wb_cyc & wb_stb & !wb_stall;
    wire may = &wb_sel & !refused & ((of_shader & idle) | (of_span & !waits));
    wire write = taken & wb_we & may;
    wire span_ready;
    assign wb_stall = wb_ack | wb_err;
    always @(posedge clk) begin
        wb_ack <= taken & (may | !wb_we) & !rst;
        wb_err <= taken & wb_we & !may & !rst;
        wb_dat_r <= read;
        if (write & pushes) waits <= 1;
        else if (span_ready) waits <= 0;
        if (rst) waits <= 0;
    end
    glint_registers registers (
        .clk(clk),
        .rst(rst),
        .write(write),
        .address(wb_adr),
        .value(wb_dat_w),
        .status({waits, idle}),
        .read(read),
        .of_shader(of_shader),
        .of_span(of_span),
        .pushes(pushes),
        .refused(refused),
        .model(model),
        .n(n),
        .c_min(c_min),
        .clamp_peak(clamp_peak),
        .ambient_red(ambient_red),
        .ambient_green(ambient_green),
        .ambient_blue(ambient_blue),
        .diffuse_red(diffuse_red),
        .diffuse_green(diffuse_green),
        .diffuse_blue(diffuse_blue),
        .specular_red(specular_red),
        .specular_green(specular_green),
        .specular_blue(specular_blue),
        .t(t),
        .dt(dt),
        .ddt(ddt),
        .nl(nl),
        .dnl(dnl),
        .w(w)
    );

    wire pixel_valid, pixel_ready, pixel_last;
    wire [15:0] pixel;
    glint_span #(
        .WHITE(WHITE),
        .ROWS(ROWS),
        .LUT_RAM(LUT_RAM),
        .ROW_AND(ROW_AND)
    ) unit (
        .clk(clk),
        .rst(rst),
        .model(model),
        .n(n),
        .c_min(c_min),
        .clamp_peak(clamp_peak),
        .ambient({ambient_red, ambient_green, ambient_blue}),
        .diffuse({diffuse_red, diffuse_green, diffuse_blue}),
        .specular({specular_red, specular_green, specular_blue}),
        .s_valid(waits),
        .s_ready(span_ready),
        .s_t(t),
        .s_dt(dt),
        .s_ddt(ddt),
        .s_nl(nl),
        .s_dnl(dnl),
        .s_w(w),
        .m_valid(pixel_valid),
        .m_ready(pixel_ready),
        .m_rgb565(pixel),
        .m_last(pixel_last),
        .idle(unit_idle)
    );

    wire skid_idle;
    assign idle = unit_idle & skid_idle & !waits;
    generate
        if (SKID != 0) begin : buffered
            glint_skid #(
                .WIDTH(17)
            ) skid (
                .clk(clk),
                .rst(rst),
                .s_valid(pixel_valid),
                .s_ready(pixel_ready),
                .s_data({pixel, pixel_last}),
                .m_valid(m_valid),
                .m_ready(m_ready),
                .m_data({m_rgb565, m_last}),
                .idle(skid_idle)
            );
        end else begin : direct
            assign {m_valid, m_rgb565, m_last} = {pixel_valid, pixel, pixel_last};
            assign pixel_ready = m_ready;
            assign skid_idle = 1'b1;
        end
    endgenerate

    generate
        if (WHITE < 0 || WHITE > 1 || ROWS < 0 || ROWS > 1 || LUT_RAM < 0 || LUT_RAM > 1 ||
            ROW_AND < 0 || ROW_AND > 1 || SKID < 0 || SKID > 1) begin : flags
            WHITE_ROWS_LUT_RAM_ROW_AND_and_SKID_must_be_0_or_1 stop ();
        end
    endgenerate
endmodule

`default_nettype wire
