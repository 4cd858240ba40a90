// SPDX-License-Identifier: MIT
// A sphere under a light that goes round it: while a line is shown, the next one's spans are prepared and shaded into
// the other half of a line buffer. The picture of frame f is the library's for the light orbit_light(f, 240).
`default_nettype none

module glint_demo (
    input wire clk, // 25.175 MHz
    input wire rst,
    input wire choose_schlick, // which model, from the next frame on
    output reg hsync,
    output reg vsync,
    output reg visible,
    output reg [15:0] rgb565 // 0 where not visible
);
    // Red plastic: n = 60; below 2^-6, less than half a step of 5 bits, there is no highlight.
    localparam [9:0] N = 60;
    localparam [16:0] C_MIN_MSH = 17'd56454, C_MIN_SCHLICK = 17'd31969;
    localparam [50:0] AMBIENT = {17'd7000, 17'd2200, 17'd1800};
    localparam [50:0] DIFFUSE = {17'd52000, 17'd13000, 17'd9000};
    localparam [50:0] SPECULAR = {3{17'd50000}};

    wire [9:0] x, y;
    wire line_end, in_picture, hsync_now, vsync_now;
    glint_video video (
        .clk(clk),
        .rst(rst),
        .x(x),
        .y(y),
        .line_end(line_end),
        .visible(in_picture),
        .hsync(hsync_now),
        .vsync(vsync_now)
    );

    // The light and the model change below the picture.
    reg [7:0] frame;
    reg model;
    wire [159:0] light;
    glint_orbit orbit (.clk(clk), .frame(frame), .light(light));
    always @(posedge clk)
        if (rst) begin
            frame <= 0;
            model <= 0;
        end else if (line_end && y == 479) begin
            frame <= frame == 239 ? 8'd0 : frame + 8'd1;
            model <= choose_schlick;
        end

    // The next line, if the sphere is in it: known from clock 2 of this line on.
    reg [9:0] row;
    reg on_sphere;
    always @(posedge clk) begin
        row <= y + 10'd1;
        on_sphere <= row > 40 && row < 440;
    end
    wire [7:0] half_width;
    wire busy, span_valid, span_ready;
    wire [31:0] t, dt, ddt, nl, dnl;
    wire [12:0] w;
    glint_sphere sphere (
        .clk(clk),
        .rst(rst),
        .start(x == 2 && on_sphere && !rst),
        .row(row[8:0]),
        .light(light),
        .busy(busy),
        .half_width(half_width),
        .m_valid(span_valid),
        .m_ready(span_ready),
        .m_t(t),
        .m_dt(dt),
        .m_ddt(ddt),
        .m_nl(nl),
        .m_dnl(dnl),
        .m_w(w)
    );
    wire pixel_valid, pixel_last, span_idle;
    wire [15:0] pixel;
    glint_span #(.WHITE(1)) span (
        .clk(clk),
        .rst(rst),
        .model(model),
        .n(N),
        .c_min(model ? C_MIN_SCHLICK : C_MIN_MSH),
        .clamp_peak(1'b0),
        .ambient(AMBIENT),
        .diffuse(DIFFUSE),
        .specular(SPECULAR),
        .s_valid(span_valid),
        .s_ready(span_ready),
        .s_t(t),
        .s_dt(dt),
        .s_ddt(ddt),
        .s_nl(nl),
        .s_dnl(dnl),
        .s_w(w),
        .m_valid(pixel_valid),
        .m_ready(1'b1),
        .m_rgb565(pixel),
        .m_last(pixel_last),
        .idle(span_idle)
    );

    // Two lines of 512: the sphere's 399 columns, modulo 512.
    reg [15:0] buffer[0:1023];
    reg [8:0] written; // pixels of the line so far
    reg [7:0] shown_half; // of the line shown; 0: no sphere in it
    reg [15:0] read;
    reg on, hsync_late, vsync_late, visible_late;
    wire [9:0] from_left = 10'd320 - {2'b0, shown_half};
    always @(posedge clk) begin
        if (pixel_valid) buffer[{row[0], 9'd320 - {1'b0, half_width} + written}] <= pixel;
        written <= x == 0 ? 9'd0 : written + {8'b0, pixel_valid};
        if (line_end) shown_half <= on_sphere ? half_width : 8'd0;
        if (rst) shown_half <= 0;

        read <= buffer[{y[0], x[8:0]}];
        on <= in_picture && shown_half != 0 && x >= from_left && x <= 10'd320 + {2'b0, shown_half};
        {hsync_late, vsync_late, visible_late} <= {hsync_now, vsync_now, in_picture};
        rgb565 <= on ? read : 16'd0;
        {hsync, vsync, visible} <= {hsync_late, vsync_late, visible_late};
    end
    wire unused = &{1'b0, busy, pixel_last, span_idle};
endmodule

`default_nettype wire
