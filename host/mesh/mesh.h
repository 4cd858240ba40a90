/* SPDX-License-Identifier: MIT
 * Meshes in double precision, before they are fitted to what the library reads. */
#ifndef GLINT_MESH_MESH_H
#define GLINT_MESH_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a file says about a part's surface; what it does not say is left to the command. */
struct mesh_material {
    bool has_color, unlit;
    uint8_t color[3];
    unsigned n; /* 0: not said */
    bool has_highlight;
    double highlight[3]; /* its hue: an OBJ's Ks, the largest channel 1; how strong it is the command says */
    bool has_roughness;
    double roughness, metallic; /* glTF's */
    unsigned look_picture;      /* green and blue are times these; its number + 1; 0: none */
    uint8_t tint[3];            /* of a metal's highlight: the colour, or the picture's mean */
    unsigned picture;           /* its number + 1; 0: none */
    bool is_nearest, clamps;    /* the picture's pixels are not blended; it does not repeat */
    double factor[3];           /* of the picture, in linear light */
};
/* What the material says in the place of what a command has, 0..1: of a glTF's roughness and metal what one lobe can show, of an OBJ's Ks
 * the hue. */
void mesh_material_look(const struct mesh_material *material, double ambient[3], double diffuse[3], double specular[3]);
/* Of a picture: the colour, unless it is none that a program means, black or the grey of what says nothing. */
void mesh_material_set_factor(struct mesh_material *material);
/* Of 0..1 a level of 255; of what is beyond the nearest one, of NaN 0. */
uint8_t mesh_level(double part);

/* A picture that faces wear, as read. */
struct mesh_picture {
    char *name; /* for messages */
    uint32_t width, height;
    uint8_t *rgb; /* as encoded, lines from the top */
};
void mesh_picture_clear(struct mesh_picture *picture); /* frees what it holds */
void mesh_pictures_free(struct mesh_picture *pictures, unsigned count);

/* How pictures become textures. */
struct texture_wish {
    size_t bytes;               /* all of them together at most, with their chains of halves */
    bool palette;               /* of 8 bits; else RGB565 */
    bool is_nearest, is_smooth; /* neither: as the file says */
};

/* x right, y up, z to the viewer. Vertices of one place differ by their normals, where the surface has a crease, by their colours, or by their
 * places in a picture. */
struct mesh {
    char *name; /* for messages */
    size_t vertex_count, face_count, place_count;
    size_t whole_vertex_count, whole_face_count; /* before edges were split */
    bool has_own_normals;                        /* of its file, at every corner */
    double split;                                /* over which angle, in degrees */
    double whole_turn;                           /* the most that a normal turned over an edge before, in degrees */
    double (*places)[3], (*normals)[3];          /* of each vertex; normals have length 1 */
    uint8_t (*colors)[3];                        /* of each vertex, as encoded; NULL: each part has one */
    double (*uv)[2];                             /* of each vertex, in its part's picture; NULL: no part has one */
    uint32_t *at;                                /* the number of each vertex's place */
    uint32_t (*faces)[3];                        /* counterclockwise from outside; by part */
    unsigned part_count;                         /* at least 1 */
    size_t *ends;                                /* the face that each part ends before */
    struct mesh_material *materials;             /* of each part */
    unsigned picture_count;
    struct mesh_picture *pictures;
    struct texture_wish wish;
    bool has_facet_colors; /* in the file: they are ignored */
};
void mesh_free(struct mesh *mesh);
unsigned mesh_part_of(const struct mesh *mesh, size_t face);

/* Vectors. */
double mesh_dot(const double a[3], const double b[3]);
void mesh_cross(const double a[3], const double b[3], double out[3]);
bool mesh_normalize(double v[3]); /* false, and v as it is, where there is no direction */
/* Of the triangle, as long as twice its area. */
void mesh_face_normal(const double a[3], const double b[3], const double c[3], double out[3]);
/* Directions of length 1 at most so many degrees apart have at least this dot product. */
double mesh_cosine(double degrees);

#endif
