#include "widgets/relief/relief_renderer.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include <QElapsedTimer>
#include <QMetaObject>
#include <QThread>

#include "core/base/hand_over.h"

namespace usar::widgets {

namespace {

/// Bit by bit, which is fast, and by which the NaN of a gap is the same as itself.
bool sameBits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
}

/// The points that show_all brings into the picture: the surface and the trails over it, but nothing far away from it.
std::vector<Vec3> pointsToShow(const mapping::ReliefScene& scene) {
    std::vector<Vec3> points = scene.surface.someCorners();
    const Rectangle bounds = scene.surface.bounds_in_map();
    for (const mapping::ReliefLine& line : scene.lines)
        std::ranges::copy_if(line.points_in_map_m, std::back_inserter(points), [&](const Vec3& point) {
            const Vec2 place_m = point.head<2>();
            return bounds.contains(place_m) && scene.surface.height_m(place_m).has_value();
        });
    return points;
}

} // namespace

ReliefRenderer::ReliefRenderer(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
}

ReliefRenderer::~ReliefRenderer() {
    pool_.waitForDone();
}

void ReliefRenderer::draw(ReliefRequest request) {
    if (working_)
        waiting_ = std::move(request);
    else
        start(std::move(request));
}

bool ReliefRenderer::renewSurface(Made& made, const ReliefRequest& request) {
    std::vector<mapping::GridIndex> changed;
    bool gone = false;
    for (const auto& [index, tile] : made.tiles)
        gone = gone || !request.tiles.contains(index);
    if (gone) // The map was cleared.
        made = {};
    for (const auto& [index, tile] : request.tiles)
        if (const auto before = made.tiles.find(index); before == made.tiles.end() || before->second != tile)
            changed.push_back(index);
    const bool same =
        changed.empty() && made.surface.cell_size_m == request.cell_size_m && made.surface.style == request.style;
    mapping::renewRelief(made.surface, request.tiles, request.cell_size_m, request.style, changed);
    made.tiles = request.tiles;
    return gone || !same;
}

void ReliefRenderer::raiseLines(Made& made, mapping::ReliefScene& scene, bool surface_changed) {
    made.lines.resize(scene.lines.size());
    for (std::size_t i = 0; i < scene.lines.size(); ++i) {
        std::vector<Vec3>& points_m = scene.lines[i].points_in_map_m;
        RaisedLine& line = made.lines[i];
        if (surface_changed || !sameBits(line.points_in_map_m, points_m)) {
            line.raised_in_map_m = mapping::aboveSurface(made.surface, points_m);
            line.points_in_map_m = std::move(points_m);
        }
        points_m = line.raised_in_map_m;
    }
}

std::shared_ptr<const ReliefFrame> ReliefRenderer::work(Made& made, ReliefRequest request) {
    QElapsedTimer clock;
    clock.start();
    const bool surface_changed = renewSurface(made, request);
    mapping::ReliefScene& scene = request.scene;
    scene.surface = made.surface;
    raiseLines(made, scene, surface_changed);
    if (request.show_all)
        scene.camera = scene.camera.showing(
            pointsToShow(scene), double(request.size_px.width()) / request.size_px.height(), scene.exaggeration);
    scene.camera = scene.camera.limited();
    for (const Rectangle& area : request.areas_in_map)
        scene.lines.push_back(
            {mapping::outlineOnSurface(scene.surface, area), request.area_color, request.edge_color, 2});
    auto frame = std::make_shared<ReliefFrame>();
    frame->picture = {request.size_px.width(), request.size_px.height()};
    frame->camera = scene.camera;
    frame->exaggeration = scene.exaggeration;
    frame->show_all = request.show_all;
    mapping::drawReliefByStrips(scene, frame->picture, std::clamp(QThread::idealThreadCount(), 1, 8));
    frame->took_ms = double(clock.nsecsElapsed()) / 1e6;
    return frame;
}

void ReliefRenderer::start(ReliefRequest request) {
    working_ = true;
    pool_.start(HandedOver([this, request = std::move(request)]() mutable {
        auto frame = work(*made_, std::move(request));
        // The destructor waits for this job, so `this` is valid here; if the object is destroyed, the queued call is
        // discarded.
        QMetaObject::invokeMethod(this, HandedOver([this, frame = std::move(frame)] {
                                      working_ = false;
                                      ++frames_;
                                      if (waiting_)
                                          start(*std::exchange(waiting_, std::nullopt));
                                      emit drawn(frame);
                                  }),
                                  Qt::QueuedConnection);
    }));
}

} // namespace usar::widgets
