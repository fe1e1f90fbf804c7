#include "widgets/relief/relief_renderer.h"

#include <algorithm>
#include <utility>

#include <QElapsedTimer>
#include <QMetaObject>
#include <QThread>

#include "core/base/hand_over.h"
#include "core/base/thread_priority.h"

namespace usar::widgets {

ReliefRenderer::ReliefRenderer(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
}

ReliefRenderer::~ReliefRenderer() {
    pool_.waitForDone();
}

void ReliefRenderer::draw(ReliefRequest request) {
    if (!working_)
        return start(std::move(request));
    if (waiting_ && !request.forgets_tiles) {
        request.forgets_tiles = waiting_->forgets_tiles;
        request.changed.merge(waiting_->changed); // The newer tile stays.
    }
    waiting_ = std::move(request);
}

bool ReliefRenderer::renewSurface(Made& made, const ReliefRequest& request) {
    mapping::ReliefSurface& surface = made.scene.surface;
    if (request.forgets_tiles) {
        made.tiles.clear();
        surface.tiles.clear();
    }
    std::vector<mapping::GridIndex> changed;
    for (const auto& [index, tile] : request.changed) {
        made.tiles[index] = tile;
        changed.push_back(index);
    }
    surface.style = request.style;
    const bool same = changed.empty() && !request.forgets_tiles && surface.cell_size_m == request.cell_size_m;
    mapping::renewRelief(surface, made.tiles, request.cell_size_m, changed);
    return !same;
}

void ReliefRenderer::raiseTrails(Made& made, const ReliefThings& things, bool surface_changed) {
    std::vector<mapping::ReliefLine>& lines = made.scene.lines;
    lines.resize(things.trails.size()); // The outlines are made anew.
    made.trails.resize(things.trails.size());
    for (std::size_t i = 0; i < things.trails.size(); ++i) {
        const ReliefTrail& trail = things.trails[i];
        if (std::exchange(made.trails[i], trail.points_in_map_m) != trail.points_in_map_m || surface_changed) {
            lines[i].points_in_map_m = mapping::aboveSurface(made.scene.surface, *trail.points_in_map_m);
            made.points_to_show.reset();
        }
        lines[i].color = trail.color;
        lines[i].edge_color = things.edge_color;
        lines[i].width_px = trail.width_px;
    }
}

std::shared_ptr<const ReliefFrame> ReliefRenderer::work(Made& made, const ReliefRequest& request) {
    QElapsedTimer clock;
    clock.start();
    mapping::ReliefScene& scene = made.scene;
    const ReliefThings& things = request.things;
    const bool surface_changed = renewSurface(made, request);
    const bool other_areas = std::exchange(made.areas_in_map, things.areas_in_map) != things.areas_in_map;
    if (surface_changed || other_areas || made.trails.size() != things.trails.size())
        made.points_to_show.reset();
    raiseTrails(made, things, surface_changed);
    scene.bodies = things.bodies;
    scene.sky = things.sky;
    scene.ground = things.ground;
    scene.exaggeration = request.exaggeration;
    scene.camera = request.camera;
    if (request.show_all) {
        if (!made.points_to_show)
            made.points_to_show = mapping::pointsToShow(scene, things.areas_in_map);
        scene.camera = scene.camera.showing(
            *made.points_to_show, double(request.size_px.width()) / request.size_px.height(), scene.exaggeration);
    }
    scene.camera = scene.camera.limited();
    for (const Rectangle& area : things.areas_in_map)
        scene.lines.push_back(
            {mapping::outlineOnSurface(scene.surface, area), things.area_color, things.edge_color, 2});
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
    pool_.start(HandedOver([this, request = std::move(request)] {
        yieldToOthers(); // The threads that draw the strips inherit it.
        auto frame = work(*made_, request);
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
