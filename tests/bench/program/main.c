/* Draws one workload with one library and says what it cost, as JSON.

   usage: program DEVICE WORKLOAD DATA FILE REPETITIONS

   DATA is a folder of files that the command `gks-bench data` writes: points as the number of parts, the number
   of points of each part, then x and y of each point; cells as columns, rows, colour indices; strings as lines
   of text. */
#define _GNU_SOURCE
#include "library.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

struct parts {
    uint32_t count;
    uint32_t *sizes;
    struct points all;
};

struct string {
    double x, y;
    char text[40];
};

static void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count + 1, size);
    if (!memory) {
        perror("memory");
        exit(2);
    }
    return memory;
}

static void read_all(void *into, size_t size, size_t count, FILE *file)
{
    if (fread(into, size, count, file) != count) {
        fprintf(stderr, "the data are too short\n");
        exit(2);
    }
}

static FILE *open_data(const char *folder, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        exit(2);
    }
    return file;
}

static struct parts read_parts(const char *folder, const char *name)
{
    FILE *file = open_data(folder, name);
    struct parts parts;
    read_all(&parts.count, sizeof parts.count, 1, file);
    parts.sizes = allocate(parts.count, sizeof *parts.sizes);
    read_all(parts.sizes, sizeof *parts.sizes, parts.count, file);
    size_t count = 0;
    for (uint32_t i = 0; i < parts.count; i++)
        count += parts.sizes[i];
    double *x = allocate(count, sizeof *x), *y = allocate(count, sizeof *y);
    float *single_x = allocate(count, sizeof *single_x), *single_y = allocate(count, sizeof *single_y);
    float *pairs = allocate(count, 2 * sizeof *pairs);
    for (size_t i = 0; i < count; i++) {
        double pair[2];
        read_all(pair, sizeof *pair, 2, file);
        x[i] = pair[0];
        y[i] = pair[1];
        pairs[2 * i] = single_x[i] = (float)pair[0];
        pairs[2 * i + 1] = single_y[i] = (float)pair[1];
    }
    fclose(file);
    parts.all = (struct points){(int)count, x, y, single_x, single_y, pairs};
    return parts;
}

static int *read_cells(const char *folder, const char *name, int size[2])
{
    FILE *file = open_data(folder, name);
    read_all(size, sizeof *size, 2, file);
    size_t count = (size_t)size[0] * (size_t)size[1];
    int *cells = allocate(count, sizeof *cells);
    read_all(cells, sizeof *cells, count, file);
    fclose(file);
    return cells;
}

static struct string *read_strings(const char *folder, const char *name, size_t *count)
{
    FILE *file = open_data(folder, name);
    struct string *strings = allocate(100000, sizeof *strings);
    *count = 0;
    while (*count < 100000
           && fscanf(file, "%lf %lf %39[^\n]", &strings[*count].x, &strings[*count].y, strings[*count].text) == 3)
        ++*count;
    fclose(file);
    return strings;
}

/* Some of the points, from the first on. */
static struct points some(struct points all, size_t first, size_t count)
{
    return (struct points){(int)count,           all.x + first,        all.y + first,
                           all.single_x + first, all.single_y + first, all.pairs + 2 * first};
}

/* Processor time of this process in seconds. */
static double cpu(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* A line of /proc/self/status in KiB. */
static long memory(const char *key)
{
    char line[256];
    long kib = 0;
    FILE *file = fopen("/proc/self/status", "r");
    while (file && fgets(line, sizeof line, file))
        if (!strncmp(line, key, strlen(key)))
            kib = atol(line + strlen(key));
    if (file)
        fclose(file);
    return kib;
}

static void each_polyline(const struct parts *parts)
{
    size_t first = 0;
    for (uint32_t i = 0; i < parts->count; first += parts->sizes[i++])
        polyline(some(parts->all, first, parts->sizes[i]));
}

int main(int count, char **arguments)
{
    if (count != 6) {
        fprintf(stderr, "usage: program DEVICE WORKLOAD DATA FILE REPETITIONS\n");
        return 2;
    }
    const char *device = arguments[1], *name = arguments[2], *data = arguments[3], *file = arguments[4];
    int repetitions = atoi(arguments[5]);
    int is_text = !strcmp(name, "w5"), is_cells = !strncmp(name, "w6", 2);
    int is_start = !strcmp(name, "w10"), has_fonts = has_stroke_fonts();
    struct parts parts = {0};
    struct string *strings = NULL;
    int *cells = NULL, size[2] = {0, 0};
    size_t string_count = 0;
    if (is_text && has_fonts)
        strings = read_strings(data, name, &string_count);
    else if (is_text)
        parts = read_parts(data, "w5strokes");
    else if (is_cells)
        cells = read_cells(data, name, size);
    else if (!is_start)
        parts = read_parts(data, name);
    struct stat status;
    if (!stat(file, &status) && S_ISREG(status.st_mode))
        unlink(file);

    long before = memory("VmRSS:");
    double start = cpu();
    if (!open_library(device, file)) {
        fprintf(stderr, "no device %s\n", device);
        return 3;
    }
    double opened = cpu();
    for (int i = 0; i < repetitions; i++) {
        int dashed = !strcmp(name, "w7");
        set_window(strcmp(name, "w8") ? 0 : 0.45, strcmp(name, "w8") ? 1 : 0.55);
        set_line(dashed, dashed ? 3 : 1, strcmp(name, "w1a") != 0);
        if (is_start) {
            static const double x[] = {0.1, 0.9};
            static const float single[] = {0.1f, 0.9f}, pairs[] = {0.1f, 0.1f, 0.9f, 0.9f};
            polyline((struct points){2, x, x, single, single, pairs});
        } else if (is_cells) {
            cell_array(size[0], size[1], cells);
        } else if (is_text && has_fonts) {
            for (size_t k = 0; k < string_count; k++)
                text(strings[k].x, strings[k].y, strings[k].text);
        } else if (!strncmp(name, "w3", 2)) {
            polymarker(!strcmp(name, "w3dot") ? 1 : !strcmp(name, "w3plus") ? 2 : 4, parts.all);
        } else if (!strncmp(name, "w4", 2)) {
            size_t first = 0;
            for (uint32_t k = 0; k < parts.count; first += parts.sizes[k++])
                fill_area(some(parts.all, first, parts.sizes[k]), 1 + (int)(k % 8));
        } else {
            each_polyline(&parts);
        }
    }
    finish_drawing();
    double drawn = cpu();
    close_library();
    double closed = cpu();

    long bytes = stat(file, &status) ? 0 : (long)status.st_size;
    double draw = (drawn - opened) / repetitions;
    printf("{\"open_ms\":%.4f,\"draw_ms\":%.4f,\"close_ms\":%.4f,\"process_ms\":%.4f,\"peak_kib\":%ld,\"bytes\":%ld}\n",
           1e3 * (opened - start), 1e3 * draw, 1e3 * (closed - drawn), 1e3 * closed, memory("VmHWM:") - before, bytes);
    return 0;
}
