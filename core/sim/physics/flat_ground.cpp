#include "core/sim/physics/flat_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <typeinfo>

#include <BulletCollision/CollisionDispatch/btConvexConcaveCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include "core/sim/physics/link_solver.h"

namespace usar::sim {

namespace {

constexpr double same_plane = 1e-9;    ///< Normals and heights that differ by less belong to one plane.
constexpr double level_tread_m = 2e-4; ///< difference of the heights of a tread's edges
constexpr double around_m = 0.3;       ///< how far the ground beside a part is looked at
constexpr int most_corners = 8;
constexpr int most_contacts = 4; ///< what a manifold of Bullet holds

struct Plane {
    btVector3 normal;      ///< unit vector, upward
    double height_m = 0.0; ///< along the normal
};

/// Looks at the triangles under a part.
struct Flatness : btTriangleCallback {
    std::optional<Plane> plane{};
    bool flat = true;

    void processTriangle(btVector3* corners, int, int) override {
        btVector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        normal *= (normal.z() < 0.0 ? -1.0 : 1.0) / normal.length();
        const double height_m = normal.dot(corners[0]);
        if (!plane)
            plane = {normal, height_m};
        else
            flat = flat && (normal - plane->normal).length2() < same_plane * same_plane &&
                   std::abs(height_m - plane->height_m) < same_plane;
    }
};

/// Points whose hull, grown by `margin_m`, is the part, as far as the lowest ones go; map frame.
struct Corners {
    std::array<btVector3, most_corners> at_m;
    int count = 0;
    double margin_m = 0.0;
    void add(const btVector3& point_m) { at_m[static_cast<std::size_t>(count++)] = point_m; }
};

void addBox(Corners& corners, const btBoxShape& box, const btTransform& part_in_map) {
    corners.margin_m = box.getMargin();
    const btVector3 half_m = box.getHalfExtentsWithoutMargin();
    for (int i = 0; i < most_corners; ++i)
        corners.add(part_in_map * btVector3(i & 1 ? half_m.x() : -half_m.x(), i & 2 ? half_m.y() : -half_m.y(),
                                            i & 4 ? half_m.z() : -half_m.z()));
}

/// Four points on each rim: the lowest one, the highest one, and those between them.
void addCylinder(Corners& corners, const btCylinderShape& rod, const btTransform& part_in_map, const btVector3& up) {
    corners.margin_m = rod.getMargin();
    const btVector3 half_m = rod.getHalfExtentsWithoutMargin();
    const btVector3 along = part_in_map.getBasis().getColumn(2);
    btVector3 down = along * up.dot(along) - up;
    // A rod that stands has no lowest point on its rim.
    down = down.length2() > same_plane ? down.normalized() : part_in_map.getBasis().getColumn(0);
    const btVector3 aside = along.cross(down);
    for (const double end : {-1.0, 1.0})
        for (const btVector3& outward : {down, -down, aside, -aside})
            corners.add(part_in_map.getOrigin() + along * (end * half_m.z()) + outward * half_m.x());
}

/// Nothing for other shapes.
Corners cornersOf(const btCollisionShape& shape, const btTransform& part_in_map, const btVector3& up) {
    Corners corners;
    switch (shape.getShapeType()) {
    case BOX_SHAPE_PROXYTYPE:
        addBox(corners, static_cast<const btBoxShape&>(shape), part_in_map);
        break;
    case CYLINDER_SHAPE_PROXYTYPE:
        addCylinder(corners, static_cast<const btCylinderShape&>(shape), part_in_map, up);
        break;
    default:
        break;
    }
    return corners;
}

class FlatGroundAlgorithm : public btConvexConcaveCollisionAlgorithm {
public:
    FlatGroundAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                        const btCollisionObjectWrapper* b, bool ground_first)
        : btConvexConcaveCollisionAlgorithm(info, a, b, ground_first)
        , ground_first_(ground_first) {
        btManifoldArray all;
        getAllContactManifolds(all);
        manifold_ = all[0];
    }

    void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo& dispatch, btManifoldResult* result) override {
        const btCollisionObjectWrapper& part = ground_first_ ? *b : *a;
        const btCollisionObjectWrapper& ground = ground_first_ ? *a : *b;
        // A test of two bodies for a callback does not use the manifold.
        const bool usual = isOnWheels(*part.getCollisionObject()) &&
                           dispatch.m_dispatchFunc == btDispatcherInfo::DISPATCH_DISCRETE &&
                           result->m_closestPointDistanceThreshold == 0.0 && isPlain(*result);
        const std::optional<Plane> plane = usual ? planeUnder(part, ground) : std::nullopt;
        if (!plane || !touch(part, ground, *plane))
            btConvexConcaveCollisionAlgorithm::processCollision(a, b, dispatch, result);
    }

private:
    /// The plane that all ground under the part lies in; nullopt if there is none. The ground around is looked at
    /// first, since the part will be there in the next steps.
    std::optional<Plane> planeUnder(const btCollisionObjectWrapper& part, const btCollisionObjectWrapper& ground) {
        const auto& field = static_cast<const btHeightfieldTerrainShape&>(*ground.getCollisionShape());
        const btVector3 at_m = ground.getWorldTransform().getOrigin(); // It is never turned.
        btVector3 low_m;
        btVector3 high_m;
        btVector3 field_low_m;
        btVector3 field_high_m;
        part.getCollisionShape()->getAabb(part.getWorldTransform(), low_m, high_m);
        field.getAabb(ground.getWorldTransform(), field_low_m, field_high_m);
        if (!within(low_m, high_m, field_low_m, field_high_m))
            return std::nullopt;
        // At all heights: the ground that drops away beneath one side of the part is not flat, either.
        const auto planeOf = [&](btVector3 from_m, btVector3 to_m) -> std::optional<Plane> {
            Flatness flatness;
            from_m.setZ(field_low_m.z());
            to_m.setZ(field_high_m.z());
            field.processAllTriangles(&flatness, from_m - at_m, to_m - at_m);
            if (!flatness.flat || !flatness.plane)
                return std::nullopt;
            flatness.plane->height_m += flatness.plane->normal.dot(at_m);
            return flatness.plane;
        };
        if (!within(low_m, high_m, around_low_m_, around_high_m_)) {
            const btVector3 more_m(around_m, around_m, 0.0);
            around_low_m_ = low_m - more_m;
            around_high_m_ = high_m + more_m;
            around_ = within(around_low_m_, around_high_m_, field_low_m, field_high_m)
                          ? planeOf(around_low_m_, around_high_m_)
                          : std::nullopt;
        }
        return around_ ? around_ : planeOf(low_m, high_m);
    }

    /// True if the first box lies in the outer one, seen from above.
    static bool within(const btVector3& low_m, const btVector3& high_m, const btVector3& outer_low_m,
                       const btVector3& outer_high_m) {
        return low_m.x() > outer_low_m.x() && low_m.y() > outer_low_m.y() && high_m.x() < outer_high_m.x() &&
               high_m.y() < outer_high_m.y();
    }

    /// Replaces the contacts by those of the lowest corners. False if the part is not above the plane.
    bool touch(const btCollisionObjectWrapper& part, const btCollisionObjectWrapper& ground, const Plane& plane) {
        Corners corners = cornersOf(*part.getCollisionShape(), part.getWorldTransform(), plane.normal);
        if (corners.count == 0 || plane.normal.dot(part.getWorldTransform().getOrigin()) < plane.height_m)
            return false;
        std::array<Low, most_corners> low{};
        int count = 0;
        for (int i = 0; i < corners.count; ++i) {
            const double gap_m =
                plane.normal.dot(corners.at_m[static_cast<std::size_t>(i)]) - plane.height_m - corners.margin_m;
            if (gap_m < manifold_->getContactBreakingThreshold())
                low[static_cast<std::size_t>(count++)] = {gap_m, i};
        }
        if (count > most_contacts) {
            std::stable_sort(low.begin(), low.begin() + count,
                             [](const Low& one, const Low& other) { return one.gap_m < other.gap_m - same_plane; });
            count = most_contacts;
        }
        count = asTire(part, corners, std::span(low).first(static_cast<std::size_t>(count)));
        const Kept kept(*manifold_);
        manifold_->setBodies(part.getCollisionObject(), ground.getCollisionObject());
        manifold_->clearManifold();
        for (int i = 0; i < count; ++i) {
            const auto [gap_m, corner] = low[static_cast<std::size_t>(i)];
            const btVector3 touching_m =
                corners.at_m[static_cast<std::size_t>(corner)] - plane.normal * corners.margin_m;
            addPoint(part, ground, plane.normal, touching_m, gap_m, corner, kept);
        }
        return true;
    }

    struct Low {
        double gap_m = 0.0;
        int corner = 0;
    };

    /// A wheel whose tread lies level touches at the middle of it, as a crowned tire does. With a point at each
    /// edge it would pivot about either of them in a bend, and the track of the robot would change by the width of its
    /// tires. Returns the number of contacts.
    static int asTire(const btCollisionObjectWrapper& part, Corners& corners, std::span<Low> low) {
        const auto count = static_cast<int>(low.size());
        const btMultiBodyLinkCollider* const link = btMultiBodyLinkCollider::upcast(part.getCollisionObject());
        const bool wheel =
            link && link->m_link >= 0 && part.getCollisionShape()->getShapeType() == CYLINDER_SHAPE_PROXYTYPE;
        if (!wheel || count != 2 || std::abs(low[0].gap_m - low[1].gap_m) > level_tread_m)
            return count;
        btVector3& first = corners.at_m[static_cast<std::size_t>(low[0].corner)];
        first = (first + corners.at_m[static_cast<std::size_t>(low[1].corner)]) / 2.0;
        low[0].gap_m = (low[0].gap_m + low[1].gap_m) / 2.0;
        return 1;
    }

    /// Copies of the contacts of the last step.
    struct Kept {
        explicit Kept(const btPersistentManifold& manifold) : count(manifold.getNumContacts()) {
            for (int i = 0; i < count; ++i)
                points[static_cast<std::size_t>(i)] = manifold.getContactPoint(i);
        }
        std::array<btManifoldPoint, most_contacts> points{};
        int count = 0;
    };

    void addPoint(const btCollisionObjectWrapper& part, const btCollisionObjectWrapper& ground, const btVector3& normal,
                  const btVector3& touching_m, double gap_m, int corner, const Kept& kept) {
        const btCollisionObject* const body = part.getCollisionObject();
        const btCollisionObject* const earth = ground.getCollisionObject();
        const btVector3 beneath_m = touching_m - normal * gap_m;
        btManifoldPoint point(body->getWorldTransform().invXform(touching_m),
                              earth->getWorldTransform().invXform(beneath_m), normal, gap_m);
        point.m_positionWorldOnA = touching_m;
        point.m_positionWorldOnB = beneath_m;
        point.m_index0 = corner;
        point.m_combinedFriction = btManifoldResult::calculateCombinedFriction(body, earth);
        point.m_combinedRestitution = btManifoldResult::calculateCombinedRestitution(body, earth);
        point.m_combinedRollingFriction = btManifoldResult::calculateCombinedRollingFriction(body, earth);
        point.m_combinedSpinningFriction = btManifoldResult::calculateCombinedSpinningFriction(body, earth);
        btPlaneSpace1(normal, point.m_lateralFrictionDir1, point.m_lateralFrictionDir2);
        for (const btManifoldPoint& old : std::span(kept.points).first(static_cast<std::size_t>(kept.count)))
            if (old.m_index0 == corner) {
                point.m_appliedImpulse = old.m_appliedImpulse;
                point.m_prevRHS = old.m_prevRHS;
                point.m_appliedImpulseLateral1 = old.m_appliedImpulseLateral1;
                point.m_appliedImpulseLateral2 = old.m_appliedImpulseLateral2;
                point.m_contactMotion1 = old.m_contactMotion1;
                point.m_contactMotion2 = old.m_contactMotion2;
                point.m_lifeTime = old.m_lifeTime + 1;
            }
        manifold_->addManifoldPoint(point);
    }

    static bool isPlain(const btManifoldResult& result) { return typeid(result) == typeid(btManifoldResult); }

    bool ground_first_;
    btPersistentManifold* manifold_ = nullptr;
    btVector3 around_low_m_{0.0, 0.0, 0.0}; ///< the ground that was looked at; at first none
    btVector3 around_high_m_{0.0, 0.0, 0.0};
    std::optional<Plane> around_; ///< all of it lies there, if it is flat
};

bool isPart(int type) {
    return type == BOX_SHAPE_PROXYTYPE || type == CYLINDER_SHAPE_PROXYTYPE;
}

/// Bullet keeps its algorithms in a pool, whose places must be large enough for ours.
btDefaultCollisionConstructionInfo roomForOurs() {
    btDefaultCollisionConstructionInfo info;
    info.m_customCollisionAlgorithmMaxElementSize = static_cast<int>(sizeof(FlatGroundAlgorithm));
    return info;
}

} // namespace

GroundConfiguration::GroundConfiguration() : btDefaultCollisionConfiguration(roomForOurs()) {}

btCollisionAlgorithm* GroundConfiguration::Maker::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                           const btCollisionObjectWrapper* a,
                                                                           const btCollisionObjectWrapper* b) {
    void* const room = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(FlatGroundAlgorithm));
    return new (room) FlatGroundAlgorithm(info, a, b, m_swapped);
}

btCollisionAlgorithmCreateFunc* GroundConfiguration::getCollisionAlgorithmCreateFunc(int type_a, int type_b) {
    if (isPart(type_a) && type_b == TERRAIN_SHAPE_PROXYTYPE)
        return &part_first_;
    if (type_a == TERRAIN_SHAPE_PROXYTYPE && isPart(type_b))
        return &ground_first_;
    return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(type_a, type_b);
}

} // namespace usar::sim
