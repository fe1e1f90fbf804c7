#include "app/window/menus.h"

namespace usar::app {

void makeMenus(QMenuBar& bar, const widgets::CommandRegistry& commands,
               const std::function<void(QMenu*)>& fill_worlds) {
    const auto tr = [](const char* text) { return QObject::tr(text); };
    const auto fill = [&](QMenu* menu, const char* ids) { commands.fill(menu, QString(ids).split(' ')); };
    const auto add = [&](const QString& title, const char* ids) {
        QMenu* const menu = bar.addMenu(title);
        fill(menu, ids);
        return menu;
    };
    add(tr("&File"), "file.open file.save - file.record file.open_recording - "
                     "file.export file.folder file.show_folder - file.quit");
    add(tr("&Mission"), "mission.area - mission.start mission.start_again mission.pause mission.land mission.stop - "
                        "mission.stop_all");
    add(tr("&Robots"), "robot.select_1 robot.select_2 robot.select_3 robot.select_4 robot.select_5 robot.select_6 "
                       "robot.select_7 robot.select_8 robot.select_9 - radio.station robot.spawn_again robot.remove - "
                       "drive.take drive.stop drive.faster drive.slower - robot.trace - plugins.rescan");
    QMenu* const server = add(tr("&Server"), "link.connect link.disconnect -");
    fill_worlds(server->addMenu(tr("&World of the embedded simulator")));
    fill(server, "simulator.open_robot simulator.save_snapshot simulator.open_snapshot simulator.cancel_opening - "
                 "time.pause time.step time.faster time.slower time.real time.max - "
                 "faults.inject faults.end faults.end_all - link.figures");
    add(tr("&Objects"), "view.dock.world - world.turn_left world.turn_right world.spin - world.waypoints "
                        "world.clear_way world.go world.halt - world.undo world.redo world.delete world.delete_all - "
                        "map.wipe_trace");
    add(tr("P&lan"), "plan.open plan.edit plan.new - "
                     "plan.continue plan.halt plan.step_cycle plan.step_epoch plan.run_to - "
                     "plan.back plan.forward plan.live plan.look_back - "
                     "plan.break_before plan.break_after plan.break_result plan.break_verdict plan.break_interruption "
                     "plan.break_key plan.break_edit plan.break_switch plan.break_clear - "
                     "plan.pin plan.drive_off plan.release - plan.report plan.save_picture");
    add(tr("M&essages"), "messages.find messages.command - messages.pause messages.follow messages.details "
                         "messages.cause messages.resend - messages.only_trouble messages.only_type "
                         "messages.hide_type messages.all_robots messages.no_filter - messages.copy "
                         "messages.copy_text messages.copy_json messages.copy_shown messages.save messages.clear");
    add(tr("Re&play"), "replay.play replay.step - replay.back replay.forward replay.begin - "
                       "replay.faster replay.slower - replay.close");
    add(tr("&Camera"), "camera.zoom_in camera.zoom_out camera.zoom_default - camera.left camera.right camera.up "
                       "camera.down camera.center - camera.light - camera.save camera.port");
    QMenu* const view = add(tr("&View"), "map.fit map.fit_world map.follow map.zoom_in map.zoom_out radio.map "
                                         "radio.show - view.operate view.analyse view.debug - view.dark view.hint "
                                         "view.palette -");
    for (const auto& command : commands.commands())
        if (command->spec.id.startsWith("view.dock."))
            view->addAction(command->action);
    add(tr("&Help"), "help.shortcuts");
}

} // namespace usar::app
