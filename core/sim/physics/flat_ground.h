// Contacts of convex parts with flat pieces of the height field, without a search for the nearest points. Internal to
// the physics.
#pragma once

#include <btBulletCollisionCommon.h>

namespace usar::sim {

/// Bullet's usual choice of algorithms, except for boxes and cylinders of robots on wheels above a height field. Where
/// all triangles under such a part lie in one plane, its lowest corners are known in closed form; each keeps its
/// impulse from step to step. Elsewhere Bullet looks for the contacts, triangle by triangle.
class GroundConfiguration : public btDefaultCollisionConfiguration {
public:
    GroundConfiguration();
    btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int type_a, int type_b) override;

private:
    struct Maker : btCollisionAlgorithmCreateFunc {
        explicit Maker(bool ground_first) { m_swapped = ground_first; }
        btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                       const btCollisionObjectWrapper* a,
                                                       const btCollisionObjectWrapper* b) override;
    };
    Maker part_first_{false};
    Maker ground_first_{true};
};

} // namespace usar::sim
