#include <array>

#include <QVBoxLayout>

#include "core/posh/language/plan_reader.h"
#include "tests/widgets/gallery/pages.h"
#include "widgets/plan/plan_panel.h"

namespace usar::gallery {

using namespace usar::widgets;

namespace {

constexpr std::string_view survey = R"((
  (documentation "Ridge survey" "gallery" "Flies over an area in lanes and comes home to charge.")
  (C get-ready (goal ((Ready)))
    (elements
      ((map    (trigger ((MapMade false))) MakeMap))
      ((ask    (trigger ((Answered false))) AskRobot 5))
      ((listen MarkReady))))
  (AP rise vars($altitude=6.0) (ClimbTo($altitude) MarkUp))
  (AP halt-and-look (StopForward PickDanger (DangerAhead 1.5 <) PlanWayAround))
  (C keep-clear
    (elements
      ((close     (trigger ((Danger 'high))) BackAway))
      ((no-matter (trigger ((OnCourse false))) HoldCourse))
      ((plan      (trigger ((WayAround false))) halt-and-look))
      ((follow    FollowWayAround))))
  (AP land (Hover LandAtBase))
  (AP land-and-charge (land Wait(8.0) Charge ResumeLane))
  (AP land-for-good (land SaveMap))
  (C fly-lanes (minutes 30) (goal ((MapSaved)))
    (elements
      ((done   (trigger ((LanesLeft 0 ==) (AtBase))) land-for-good))
      ((charge (trigger ((HomeBound) (AtBase))) land-and-charge))
      ((home   (trigger ((HomeBound))) FlyHome) (next (trigger ((GoalReached))) NextGoal 200))
      ((fly    FlyToGoal($speed=2.5)))))
  (DC ridge-survey (goal ((MissionOver)))
    (drives
      ((launch  (trigger ((Ready false))) get-ready))
      ((takeoff (trigger ((Up false) (OnGround false))) rise(6.0)))
      ((battery (trigger ((BatteryMargin 0.15 <) (HomeBound false))) TurnHome (seconds 10) "keeps 15 % for the way"))
      ((obstacle (trigger ((SonarRange 1.8 <))) keep-clear))
      ((report SendReport (seconds 5)) (lanes fly-lanes))))
)
)";

struct Flight {
    std::vector<std::string> paths;
    std::vector<PlanActivity> activities;
    Seconds now{751.0};

    PlanActivity& at(const std::string& path) {
        paths.push_back("/P:0/DC:0" + path);
        return activities.emplace_back();
    }
    void ran(const std::string& path, double ago_s, std::uint64_t started, std::uint64_t failed = 0,
             std::uint64_t skipped = 0) {
        PlanActivity& part = at(path);
        part.running = ago_s == 0.0;
        part.last_active = now - Seconds(ago_s);
        part.started = started;
        part.succeeded = started - failed - (part.running ? 1 : 0);
        part.failed = failed;
        part.skipped = skipped;
    }
    void said(const std::string& path, const char* value, bool holds, double since_s, double asked_ago_s = 0.0) {
        at(path).answer =
            SenseAnswer{QString::fromLatin1(value), holds, now - Seconds(since_s), now - Seconds(asked_ago_s)};
    }
};

/// On the way along the fourth lane, shortly after an obstacle.
PlanSnapshot midFlight() {
    Flight f;
    f.ran("", 0.0, 1);
    f.said("/S:0", "false", false, 751.0);
    f.ran("/DE:0", 742.0, 1);
    f.said("/DE:0/S:0", "true", false, 741.0);
    f.ran("/DE:0/A:0/C:0", 742.0, 1);
    f.ran("/DE:1", 731.0, 2);
    f.said("/DE:1/S:0", "true", false, 730.0);
    f.ran("/DE:2", 300.0, 1, 0, 3);
    f.said("/DE:2/S:0", "0.38", false, 214.0);
    f.ran("/DE:3", 1.4, 6, 1);
    f.said("/DE:3/S:0", "2.41", false, 1.2);
    f.ran("/DE:3/A:0/C:1", 1.4, 6, 1);
    f.ran("/DE:3/A:0/C:1/CE:3", 1.4, 5);
    f.ran("/DE:3/A:0/C:1/CE:3/A:0", 1.4, 5);
    f.said("/DE:3/A:0/C:1/CE:0/S:0", "'low", false, 9.0, 1.4);
    f.said("/DE:3/A:0/C:1/CE:1/S:0", "true", false, 9.0, 1.4);
    f.said("/DE:3/A:0/C:1/CE:2/S:0", "true", false, 7.8, 1.4);
    f.ran("/DE:3/A:0/C:1/CE:2", 7.8, 6, 1);
    f.ran("/DE:4", 3.0, 148, 0, 2950);
    f.at("/DE:4").hold_back = QStringLiteral("its frequency: 2.0 s left");
    f.ran("/DE:4/A:0", 3.0, 148);
    f.ran("/DE:5", 0.0, 9);
    f.ran("/DE:5/A:0/C:2", 0.0, 9);
    f.said("/DE:5/A:0/C:2/S:0", "false", false, 751.0);
    f.said("/DE:5/A:0/C:2/CE:0/S:0", "5", false, 96.0);
    f.said("/DE:5/A:0/C:2/CE:1/S:0", "false", false, 214.0);
    f.said("/DE:5/A:0/C:2/CE:2/S:0", "false", false, 214.0);
    f.said("/DE:5/A:0/C:2/CE:3/S:0", "false", false, 4.6);
    f.ran("/DE:5/A:0/C:2/CE:3", 4.8, 31);
    f.ran("/DE:5/A:0/C:2/CE:4", 0.0, 12840, 2);
    f.ran("/DE:5/A:0/C:2/CE:4/A:0", 0.0, 12840, 2);
    return {std::make_shared<const std::vector<std::string>>(f.paths), f.activities, f.now};
}

std::unique_ptr<PlanPanel> panel(QSize size) {
    auto made = std::make_unique<PlanPanel>();
    made->resize(size);
    made->setPlan(posh::readPlan(survey).plan);
    made->setSnapshot(midFlight());
    return made;
}

} // namespace

std::unique_ptr<QWidget> planPage() {
    auto page = panel({1280, 800});
    page->view().selectPath("/P:0/DC:0/DE:3/A:0/C:1/CE:2");
    return page;
}

std::unique_ptr<QWidget> narrowPlanPage() {
    auto page = panel({320, 760});
    page->view().selectPath("/P:0/DC:0/DE:2");
    return page;
}

std::unique_ptr<QWidget> dockedPlanPage() {
    return panel({1100, 300});
}

std::unique_ptr<QWidget> wholePlanPage() {
    auto page = panel({700, 500});
    page->view().fit();
    return page;
}

std::unique_ptr<QWidget> planTextPage() {
    auto page = panel({1280, 640});
    std::string text(survey);
    text.insert(text.find("(AP rise"), "(AP spare (Hover (hours)))\n  ; what is left over\n  (AP broken ())\n  ");
    page->setPlan(posh::readPlan(text).plan);
    page->setPlanText(text, posh::readPlan(text).findings);
    page->setSnapshot(midFlight());
    page->view().selectPath("/P:0/DC:0/DE:3");
    return page;
}

std::unique_ptr<QWidget> emptyPlanPage() {
    auto page = std::make_unique<PlanPanel>();
    page->resize(900, 360);
    return page;
}

} // namespace usar::gallery
