/* Where the page's player begins, and where the host's own triangles stand in the town. */
#ifndef RUBBLE_HOSTS_WEB_TOWN_H
#define RUBBLE_HOSTS_WEB_TOWN_H
#include "samples/hosts/support/yard.h"

static const struct yard_start kTownStart = {{9.0, 0.2, 43.0}, -1.024, 0.05};
/* One before the house, one that reaches through its wall. */
static const float kTownPyramids[2][3] = {{13.0f, 0.2f, 40.5f}, {17.0f, 0.2f, 37.0f}};
#endif
