#include <QTimer>

#include "tests/widgets/gallery/pages.h"
#include "widgets/plan/editor/plan_editor.h"

namespace usar::gallery {

using namespace usar::widgets;

namespace {

constexpr const char* rover = R"((
  (documentation "Rover" "gallery" "Follows a wall and comes home when it is dark.")

  ; What it does with a thing in its way.
  (AP back-off (Stop Reverse(0.4) TurnAway))
  (C follow-wall
    (elements
      ((too-near (trigger ((WallDistance 0.4 <))) SteerAway))
      ((too-far  (trigger ((WallDistance 1.2 >))) SteerCloser))
      ((along    DriveAhead($speed=0.6)))))

  (DC rover (goal ((AtHome)))
    (drives
      ((bumper (trigger ((Bumped))) back-off))
      ((night  (trigger ((Light 20 <) (AtHome false))) DriveHome (seconds 5)))
      ((work   follow-wall)))))
)";

std::vector<agent::PrimitiveDescription> roverPrimitives() {
    using agent::AnswerType;
    using agent::PoshParameter;
    using agent::PrimitiveKind;
    std::vector<agent::PrimitiveDescription> all{
        {"AtHome",
         PrimitiveKind::Sense,
         {},
         AnswerType::Boolean,
         {},
         "It stands within 0.5 m of its base.",
         {"GroundTruth"}},
        {"Bumped", PrimitiveKind::Sense, {}, AnswerType::Boolean, {}, "A bumper is pressed.", {"Touch"}},
        {"Light", PrimitiveKind::Sense, {}, AnswerType::Integer, "lux", "How light it is.", {}},
        {"WallDistance", PrimitiveKind::Sense, {}, AnswerType::Real, "m", "To the wall at its right.", {"Sonar"}},
        {"DriveAhead",
         PrimitiveKind::Act,
         {PoshParameter::number("speed", 0.5, "m/s", 0.0, 1.5, "How fast")},
         AnswerType::Any,
         {},
         "One step straight ahead.",
         {"DRIVE"}},
        {"Reverse",
         PrimitiveKind::Act,
         {PoshParameter::number("way", 0.5, "m", 0.0, 2.0, "How far")},
         AnswerType::Any,
         {},
         "Drives backward.",
         {"DRIVE"}}};
    for (const char* const name : {"DriveHome", "SteerAway", "SteerCloser", "Stop", "TurnAway"})
        all.push_back({name, PrimitiveKind::Act, {}, AnswerType::Any, {}, "Does what its name says.", {"DRIVE"}});
    return all;
}

std::unique_ptr<PlanEditor> editor(QSize size, const std::string& text) {
    auto made = std::make_unique<PlanEditor>();
    made->resize(size);
    made->setPrimitives(roverPrimitives());
    made->setText(text, QStringLiteral("rover.lap"));
    made->setApplicable(true);
    return made;
}

} // namespace

std::unique_ptr<QWidget> planEditorPage() {
    auto page = editor({1280, 760}, rover);
    page->setRunningPlan(QStringLiteral("the plan of R1"), rover);
    QTimer::singleShot(50, page.get(), [editor = page.get()] {
        editor->canvas().selectPath("/P:0/DC:0/DE:1");
        editor->action(QStringLiteral("move_up"))->trigger();
        editor->action(QStringLiteral("compare_running"))->trigger();
    });
    return page;
}

std::unique_ptr<QWidget> narrowPlanEditorPage() {
    return editor({360, 800}, rover);
}

std::unique_ptr<QWidget> faultyPlanEditorPage() {
    std::string text(rover);
    text.replace(text.find("SteerCloser"), 11, "SteerClozer");
    auto page = editor({1280, 760}, text);
    QTimer::singleShot(50, page.get(), [editor = page.get()] {
        QTextCursor cursor = editor->textEdit().textCursor();
        cursor.setPosition(static_cast<int>(editor->text().find("SteerClozer")));
        editor->textEdit().setTextCursor(cursor);
        editor->textEdit().setLamp(true);
        editor->canvas().selectPath("/P:0/DC:0/DE:2/A:0/C:0/CE:1/S:0");
        editor->action(QStringLiteral("edit"))->trigger();
    });
    return page;
}

} // namespace usar::gallery
