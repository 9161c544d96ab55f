namespace rubble {}
