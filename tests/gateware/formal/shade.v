// SPDX-License-Identifier: MIT
// The shading under any pixels and any taking: what it offers is held; with COUNT: as many pixels come out as went in.
`default_nettype none

module shade (
    input wire clk,
    input wire rst,
    input wire clamp_peak,
    input wire [50:0] ambient,
    input wire [50:0] diffuse,
    input wire [50:0] specular,
    input wire s_valid,
    input wire [16:0] s_f,
    input wire [16:0] s_nl,
    input wire s_last,
    input wire m_ready
);
    wire s_ready, m_valid, m_last;
    wire [15:0] m_rgb565;
    glint_shade #(.WHITE(1)) dut (
        .clk(clk),
        .rst(rst),
        .clamp_peak(clamp_peak),
        .ambient(ambient),
        .diffuse(diffuse),
        .specular(specular),
        .s_valid(s_valid),
        .s_ready(s_ready),
        .s_f(s_f),
        .s_nl(s_nl),
        .s_last(s_last),
        .m_valid(m_valid),
        .m_ready(m_ready),
        .m_rgb565(m_rgb565),
        .m_last(m_last)
    );
    held #(.WIDTH(17)) offered (.clk(clk), .rst(rst), .valid(m_valid), .ready(m_ready), .data({m_rgb565, m_last}));

`ifdef COUNT
    reg [7:0] inside, lasts;
    always @(posedge clk) begin
        inside <= rst ? 0 : inside + (s_valid & s_ready) - (m_valid & m_ready);
        lasts <= rst ? 0 : lasts + (s_valid & s_ready & s_last) - (m_valid & m_ready & m_last);
        if (!rst & m_valid) assert (inside != 0 && inside <= 5 && (!m_last | lasts != 0));
        if (!rst & !m_valid) assert (s_ready && inside <= 4);
    end
`endif
endmodule

`default_nettype wire
