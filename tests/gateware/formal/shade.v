// SPDX-License-Identifier: MIT
// The shading under any pixels and any taking, for ever: as many come out as went in, what is offered stays, idle
// says that nothing is inside.
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
    wire s_ready, m_valid, m_last, idle;
    wire [15:0] m_rgb565;
    wire [4:0] valid;
    glint_shade dut (
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
        .m_last(m_last),
        .idle(idle),
        .valid(valid) // exposed by test_span_handshake
    );
    held #(
        .WIDTH(17)
    ) offered (
        .clk(clk),
        .rst(rst),
        .valid(m_valid),
        .ready(m_ready),
        .data({m_rgb565, m_last})
    );

    reg begun = 0;
    reg [3:0] inside;
    always @(posedge clk) begin
        begun <= 1;
        inside <= rst ? 4'd0 : inside + {3'd0, s_valid & s_ready} - {3'd0, m_valid & m_ready};
        if (begun) begin
            assert (inside == {3'd0, valid[0]} + {3'd0, valid[1]} + {3'd0, valid[2]} + {3'd0, valid[3]} +
                {3'd0, valid[4]});
            assert (idle == (inside == 0));
            assert (s_ready == (!m_valid | m_ready));
        end
    end
endmodule

`default_nettype wire
