#pragma once
#include <rubble/rubble.h>

#include <array>
#include <string>
#include <vector>

namespace stress {

/// What a scenario has asked of the program that runs it. Its functions of C find it in ScriptWorld::host.
struct SceneRequests {
    enum Kind { SaveAndLoad, LoadLevel };
    struct Request {
        Kind kind;
        std::string level;  ///< LoadLevel: its name
    };
    std::vector<Request> waiting;  ///< to be done after the step, in this order
    std::string unmet;             ///< the first Expect() that was not met
    bool isClosed = false;         ///< ClosedSystem(): nothing gives energy to bodies
    bool isFree = false;           ///< FreeFlight(): bodies touch nothing
    /// Of ExactHole(): how many voxels a step shall remove from a shape.
    struct Hole {
        struct Ball {
            std::array<double, 3> center;
            double radius;
        };
        rubble_shape shape;
        uint64_t step;            ///< that carries it out, counted from 1
        uint64_t voxels;          ///< in any of the balls
        std::vector<Ball> balls;  ///< of all calls for the shape in that step, in cells
    };
    std::vector<Hole> holes;
    uint64_t extraSteps = 0;  ///< of the world, of which scripts know nothing
    bool undoWaits = false;   ///< for the next step: nothing can be saved before it
};

}  // namespace stress
