// SPDX-License-Identifier: MIT
// From F and nl to RGB565: min(1, ambient + diffuse nl + specular F) a channel, one rounding at the end. Coefficients
// {red, green, blue}, 17 bits each, 0..65536 = 1.0, are held still while pixels are inside.
`default_nettype none

module glint_shade #(
    parameter integer WHITE = 0, // 1: the specular coefficient of red is that of all; two products less
    parameter integer ROWS = 1, // 1: those two are made of logic cells, not of multiplier blocks
    parameter integer ROW_AND = 0 // as in glint_row
) (
    input wire clk,
    input wire rst,
    input wire clamp_peak,
    input wire [50:0] ambient,
    input wire [50:0] diffuse,
    input wire [50:0] specular,
    input wire s_valid,
    output wire s_ready,
    input wire [16:0] s_f,
    input wire [16:0] s_nl,
    input wire s_last,
    output wire m_valid,
    input wire m_ready,
    output wire [15:0] m_rgb565,
    output wire m_last,
    output wire idle // no pixel is inside
);
    // All stages move together; they stand still while a pixel at the end is not taken.
    localparam STAGES = 5;
    reg [STAGES-1:0] valid, last;
    wire step = !valid[STAGES-1] | m_ready;
    assign s_ready = step;
    assign idle = valid == 0;
    assign m_valid = valid[STAGES-1];
    assign m_last = last[STAGES-1];
    always @(posedge clk) begin
        if (step) begin
            valid <= {valid[STAGES-2:0], s_valid};
            last <= {last[STAGES-2:0], s_last};
        end
        if (rst) valid <= 0;
    end

    // 1: step 3 of lib/sequence.md
    reg [16:0] f, nl;
    always @(posedge clk)
        if (step) begin
            nl <= s_nl;
            f <= s_nl == 0 ? 17'd0 : clamp_peak & s_f[16] ? 17'd65536 : s_f;
        end

    // 2, 3: the products. F <= 67109: they fit in 33 bits.
    wire [33:0] shine_red;
    reg [32:0] specular_red;
    glint_product product_red (
        .clk(clk),
        .step(step),
        .a(specular[50:34]),
        .x(f),
        .p(shine_red)
    );
    always @(posedge clk) if (step) specular_red <= shine_red[32:0];
    wire unused_red = shine_red[33];

    genvar k;
    generate
        for (k = 0; k < 3; k = k + 1) begin : channel
            localparam BITS = k == 1 ? 6 : 5;
            wire [33:0] lit;
            reg [33:0] lit_sum, y;
            reg [BITS-1:0] out;
            wire [32:0] shine;
            wire [BITS-1:0] level;
            glint_product product (
                .clk(clk),
                .step(step),
                .a(diffuse[17*k+:17]),
                .x(nl),
                .p(lit)
            );
            if (k == 2 || WHITE != 0) begin : common
                assign shine = specular_red;
            end else begin : own
                wire [33:0] p;
                reg [32:0] late;
                glint_product #(
                    .ROWS(ROWS),
                    .ROW_AND(ROW_AND)
                ) product (
                    .clk(clk),
                    .step(step),
                    .a(specular[17*k+:17]),
                    .x(f),
                    .p(p)
                );
                always @(posedge clk) if (step) late <= p[32:0];
                assign shine = late;
                wire unused = p[33];
            end
            // 4: at most 3.03 * 2^32.  5: the level.
            glint_level #(.BITS(BITS)) rounding (.y(y), .level(level));
            always @(posedge clk)
                if (step) begin
                    lit_sum <= lit + {1'b0, ambient[17*k+:17], 16'b0};
                    y <= lit_sum + {1'b0, shine};
                    out <= level;
                end
        end
    endgenerate
    assign m_rgb565 = {channel[2].out, channel[1].out, channel[0].out};

    generate
        if (WHITE != 0) begin : white
            wire unused = &{1'b0, specular[33:0]};
        end
    endgenerate
endmodule

`default_nettype wire
