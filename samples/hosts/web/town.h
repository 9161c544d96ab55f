/* Where the page's player begins, and where the host's own triangles stand in the town. */
#ifndef RUBBLE_HOSTS_WEB_TOWN_H
#define RUBBLE_HOSTS_WEB_TOWN_H
#include "samples/hosts/support/yard.h"

static const struct yard_start kTownStart = {{9.0, 0.2, 43.0}, -1.024, 0.05};
/* One before the fence of the house, one behind it. */
static const float kTownPyramids[2][3] = {{12.0f, 0.2f, 39.3f}, {14.7f, 0.2f, 36.9f}};
#endif
