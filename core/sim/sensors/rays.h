// Ray casting for range sensors: against the still world and against other robots and objects.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/sim/physics/physics.h"
#include "core/sim/rays/ray_caster.h"

namespace usar::sim {

/// Interface of what a range sensor measures with.
class Rays {
public:
    virtual ~Rays() = default;
    /// Distance to the first thing hit, `maximum_m` on a miss. `direction` is a unit vector; map frame.
    virtual double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const = 0;
    /// Replaces `distances_m` by what `cast` gives for each of these rays.
    virtual void castEach(const Vec3& origin_m, std::span<const Vec3> directions, double maximum_m,
                          std::vector<double>& distances_m) const {
        distances_m.clear();
        for (const Vec3& direction : directions)
            distances_m.push_back(cast(origin_m, direction, maximum_m));
    }
    /// The shortest distance of several rays, at least one. Bit for bit the minimum of `cast` over all of them.
    virtual double castNearest(const Vec3& origin_m, std::span<const Vec3> directions, double maximum_m) const {
        for (const Vec3& direction : directions)
            maximum_m = cast(origin_m, direction, maximum_m);
        return maximum_m;
    }
    /// What a sonar hears: the distance to the nearest first hit, of at least one ray, that sends an echo; `maximum_m`
    /// if there is none. Unless it is overridden, everything does.
    virtual double nearestEcho(const Vec3& origin_m, std::span<const Vec3> directions, double maximum_m) const {
        return castNearest(origin_m, directions, maximum_m);
    }
};

/// Meets everything except the robot that looks. Its references must outlive it.
class WorldRays : public Rays {
public:
    /// `self` is the body of the robot that looks, which its own rays pass through.
    WorldRays(const RayCaster& still, const Physics& moving, BodyId self)
        : still_(still)
        , moving_(moving)
        , self_(self) {}

    /// Asks the still world first, so that fewer bodies have to be tested.
    double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const override {
        const double still_m = still_.cast(origin_m, direction, maximum_m);
        return moving_.castAtBodies(origin_m, direction, maximum_m, still_m, self_);
    }

    /// Neighbors of a scan have the same few things before them.
    void castEach(const Vec3& origin_m, std::span<const Vec3> directions, double maximum_m,
                  std::vector<double>& distances_m) const override {
        constexpr std::size_t neighbors = 16;
        distances_m.clear();
        for (std::size_t first = 0; first < directions.size(); first += neighbors) {
            const auto some = directions.subspan(first, std::min(neighbors, directions.size() - first));
            const RayBundle bundle(origin_m, some);
            const NearThings things = still_.thingsNear(bundle, maximum_m);
            const bool bodies = moving_.hasBodies(bundle.box(maximum_m), self_);
            for (const Vec3& direction : some) {
                const double still_m = still_.cast(origin_m, direction, maximum_m, things);
                distances_m.push_back(bodies ? moving_.castAtBodies(origin_m, direction, maximum_m, still_m, self_)
                                             : still_m);
            }
        }
    }

    /// Skips the bodies altogether if none reaches into the box around the rays.
    double castNearest(const Vec3& origin_m, std::span<const Vec3> directions, double maximum_m) const override {
        const RayBundle bundle(origin_m, directions);
        double nearest_m = still_.castNearest(bundle, maximum_m);
        if (moving_.hasBodies(bundle.box(nearest_m), self_))
            for (const Vec3& direction : directions)
                nearest_m = moving_.castAtBodies(origin_m, direction, maximum_m, nearest_m, self_);
        return nearest_m;
    }

    /// Bodies always answer; for the still world see RayCaster::sendsEcho.
    double nearestEcho(const Vec3& origin_m, std::span<const Vec3> directions, double maximum_m) const override {
        const RayBundle bundle(origin_m, directions);
        const bool bodies = moving_.hasBodies(bundle.box(maximum_m), self_);
        if (!bodies && still_.castNearest(bundle, maximum_m) >= maximum_m)
            return maximum_m;
        const NearThings things = still_.thingsNear(bundle, maximum_m);
        double nearest_m = maximum_m;
        for (const Vec3& direction : directions) {
            const RayHit still = still_.look(origin_m, direction, nearest_m, things);
            const double body_m =
                bodies ? moving_.castAtBodies(origin_m, direction, maximum_m, still.distance_m, self_) : maximum_m;
            if (body_m < still.distance_m || still_.sendsEcho(origin_m, direction, still))
                nearest_m = std::min(body_m, still.distance_m);
        }
        return nearest_m;
    }

private:
    const RayCaster& still_;
    const Physics& moving_;
    BodyId self_;
};

} // namespace usar::sim
