// SPDX-License-Identifier: MIT
// glint_shade as the function that it is where its registers are wires: each channel is the level of min(1, ambient +
// diffuse nl + specular F). Products are free values (formal/glint_product.v) of which their bounds are known, and
// are asked for rightly.
`default_nettype none

module pixel (
    input wire clamp_peak,
    input wire [50:0] ambient,
    input wire [50:0] diffuse,
    input wire [50:0] specular,
    input wire [16:0] f,
    input wire [16:0] nl
);
    wire [15:0] rgb565;
    // The highlight's red, green and blue, then the diffuse ones; exposed by test_span_handshake.
    wire [16:0] a0, x0;
    wire [33:0] p0;
    wire [16:0] a1, x1;
    wire [33:0] p1;
    wire [16:0] a2, x2;
    wire [33:0] p2;
    wire [16:0] a3, x3;
    wire [33:0] p3;
    wire [16:0] a4, x4;
    wire [33:0] p4;
    wire [16:0] a5, x5;
    wire [33:0] p5;
    glint_shade dut (
        .clk(1'b0),
        .rst(1'b0),
        .clamp_peak(clamp_peak),
        .ambient(ambient),
        .diffuse(diffuse),
        .specular(specular),
        .s_f(f),
        .s_nl(nl),
        .m_rgb565(rgb565),
        .\product_red.a (a0),
        .\product_red.x (x0),
        .\product_red.p (p0),
        .\channel[1].own.product.a (a1),
        .\channel[1].own.product.x (x1),
        .\channel[1].own.product.p (p1),
        .\channel[0].own.product.a (a2),
        .\channel[0].own.product.x (x2),
        .\channel[0].own.product.p (p2),
        .\channel[2].product.a (a3),
        .\channel[2].product.x (x3),
        .\channel[2].product.p (p3),
        .\channel[1].product.a (a4),
        .\channel[1].product.x (x4),
        .\channel[1].product.p (p4),
        .\channel[0].product.a (a5),
        .\channel[0].product.x (x5),
        .\channel[0].product.p (p5)
    );

    wire [16:0] shine = nl == 0 ? 17'd0 : (clamp_peak && f > 65536) ? 17'd65536 : f;
    function [39:0] sum(input [33:0] lit, input [16:0] always_there, input [33:0] lustre);
        reg [39:0] all;
        begin
            all = {6'd0, lit} + {7'd0, always_there, 16'd0} + {6'd0, lustre};
            sum = all > 40'h100000000 ? 40'h100000000 : all;
        end
    endfunction
    wire [39:0] red = sum(p3, ambient[50:34], p0);
    wire [39:0] green = sum(p4, ambient[33:17], p1);
    wire [39:0] blue = sum(p5, ambient[16:0], p2);
    wire [39:0] red_level = (red * 40'd31 + 40'h80000000) >> 32;
    wire [39:0] green_level = (green * 40'd63 + 40'h80000000) >> 32;
    wire [39:0] blue_level = (blue * 40'd31 + 40'h80000000) >> 32;
    always @* begin
        assume (f <= 67109 && nl <= 65536);
        assume (ambient[50:34] <= 65536 && ambient[33:17] <= 65536 && ambient[16:0] <= 65536);
        // Of factors of at most 2^16 and 67109.
        assume (p0 <= 34'd4398055424 && p1 <= 34'd4398055424 && p2 <= 34'd4398055424);
        assume (p3 <= 34'h100000000 && p4 <= 34'h100000000 && p5 <= 34'h100000000);
        assert ({a0, a1, a2} == specular && x0 == shine && x1 == shine && x2 == shine);
        assert ({a3, a4, a5} == diffuse && x3 == nl && x4 == nl && x5 == nl);
        assert (rgb565 == {red_level[4:0], green_level[5:0], blue_level[4:0]});
    end
endmodule

`default_nettype wire
