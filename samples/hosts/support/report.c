#include "samples/hosts/support/report.h"

#include <png.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

uint64_t resident_kib(void) {
    unsigned long all = 0, resident = 0;
    FILE* file = fopen("/proc/self/statm", "r");
    if (!file) return 0;
    if (fscanf(file, "%lu %lu", &all, &resident) != 2) resident = 0;
    fclose(file);
    return (uint64_t)resident * (uint64_t)sysconf(_SC_PAGESIZE) / 1024;
}

int write_png(const char* path, uint32_t width, uint32_t height, const uint8_t* rgb) {
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = width, image.height = height, image.format = PNG_FORMAT_RGB;
    return png_image_write_to_file(&image, path, 0, rgb, -3 * (int)width, NULL);
}
