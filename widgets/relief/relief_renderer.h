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

/// What a frame is to show: plain values and immutable tiles.
struct ReliefRequest {
    mapping::HeightTiles tiles{};
    double cell_size_m = 0.25;
    mapping::ReliefStyle style{};
    mapping::ReliefScene scene{};          ///< without surface; its lines are raised above it
    std::vector<Rectangle> areas_in_map{}; ///< outlined on the surface, in the color below
    std::uint32_t area_color = 0;          ///< 0xffRRGGBB, and so is the next
    std::uint32_t edge_color = 0;          ///< of trails and outlines
    bool show_all = false;                 ///< the camera moves so that all of the surface is seen
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

/// One job runs at a time and draws in as many threads as there are processors. A request that comes meanwhile waits,
/// and replaces the one that waited before it. GUI thread.
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
    struct RaisedLine {
        std::vector<Vec3> points_in_map_m; ///< as they were requested
        std::vector<Vec3> raised_in_map_m; ///< above the surface
    };
    /// What the job keeps for the next one: tiles and lines that are the same are not made again.
    struct Made {
        mapping::ReliefSurface surface;
        mapping::HeightTiles tiles;
        std::vector<RaisedLine> lines; ///< in the order of the scene
    };
    static std::shared_ptr<const ReliefFrame> work(Made& made, ReliefRequest request);
    /// False if the surface stays as it is.
    static bool renewSurface(Made& made, const ReliefRequest& request);
    static void raiseLines(Made& made, mapping::ReliefScene& scene, bool surface_changed);
    void start(ReliefRequest request);

    std::unique_ptr<Made> made_ = std::make_unique<Made>(); ///< only the running job uses it
    std::optional<ReliefRequest> waiting_;
    bool working_ = false;
    int frames_ = 0;
    QThreadPool pool_;
};

} // namespace usar::widgets
