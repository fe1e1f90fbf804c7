// Draws frames of the 3D view in worker threads; the newest request wins.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QSize>
#include <QThreadPool>

#include "core/mapping/relief/relief_scene.h"

namespace usar::widgets {

/// Points that nobody changes any more.
using SharedPoints = std::shared_ptr<const std::vector<Vec3>>;

/// The way of a robot, which is raised above the surface. Two are the same if they share their points.
struct ReliefTrail {
    SharedPoints points_in_map_m;
    std::uint32_t color = 0xffffffffu; ///< 0xffRRGGBB
    int width_px = 2;
    bool operator==(const ReliefTrail&) const = default;
};

/// What is seen beside the surface, in the colors of the theme; it is cheap to copy and to compare.
struct ReliefThings {
    std::vector<ReliefTrail> trails{};
    std::vector<mapping::ReliefBody> bodies{};
    std::vector<Rectangle> areas_in_map{}; ///< outlined on the surface
    // As 0xffRRGGBB:
    std::uint32_t area_color = 0;
    std::uint32_t edge_color = 0; ///< of trails and outlines
    std::uint32_t sky = 0;
    std::uint32_t ground = 0; ///< where nothing is known
    bool operator==(const ReliefThings&) const = default;
};

/// What a frame is to show: plain values and immutable tiles.
struct ReliefRequest {
    bool forgets_tiles = false;     ///< those of earlier requests are gone
    mapping::HeightTiles changed{}; ///< those that are new or other ones since the request before
    double cell_size_m = 0.25;
    mapping::ReliefStyle style{};
    ReliefThings things{};
    mapping::OrbitCamera camera{};
    double exaggeration = 1.0;
    bool show_all = false; ///< the camera moves so that all of the surface is seen
    QSize size_px{};
};

/// A finished picture with what is needed to find places in it.
struct ReliefFrame {
    mapping::ReliefPicture picture;
    mapping::OrbitCamera camera;
    double exaggeration = 1.0;
    bool show_all = false; ///< as it was requested
    double took_ms = 0.0;  ///< time of the whole job: the surface, the lines and the drawing
    /// For places in pixels of this picture.
    mapping::ReliefProjection projection() const { return {camera, picture.width_px, picture.height_px, exaggeration}; }
};

/// One job runs at a time and draws in as many threads as there are processors, after those that the sessions need. A
/// request that comes meanwhile waits, and replaces the one that waited before it, whose tiles it takes over. GUI
/// thread.
class ReliefRenderer : public QObject {
    Q_OBJECT
public:
    explicit ReliefRenderer(QObject* parent = nullptr);
    ~ReliefRenderer() override; ///< waits for the job

    void draw(ReliefRequest request);
    bool busy() const { return working_; }
    int frameCount() const { return frames_; } ///< finished ones

signals:
    void drawn(const std::shared_ptr<const usar::widgets::ReliefFrame>& frame);

private:
    /// What the job keeps for the next one: tiles and lines that are the same are not made again.
    struct Made {
        mapping::HeightTiles tiles;
        mapping::ReliefScene scene;       ///< its lines are the trails above the surface, and then the outlines
        std::vector<SharedPoints> trails; ///< what the first lines were made of
        std::vector<Rectangle> areas_in_map;
        std::optional<std::vector<Vec3>> points_to_show; ///< nullopt: not known for these
    };
    static std::shared_ptr<const ReliefFrame> work(Made& made, const ReliefRequest& request);
    /// False if the surface stays as it is.
    static bool renewSurface(Made& made, const ReliefRequest& request);
    static void raiseTrails(Made& made, const ReliefThings& things, bool surface_changed);
    void start(ReliefRequest request);

    std::unique_ptr<Made> made_ = std::make_unique<Made>(); ///< only the running job uses it
    std::optional<ReliefRequest> waiting_;
    bool working_ = false;
    int frames_ = 0;
    QThreadPool pool_;
};

} // namespace usar::widgets
