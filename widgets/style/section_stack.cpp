#include "widgets/style/section_stack.h"

#include <algorithm>
#include <utility>

#include <QSignalBlocker>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

SectionStack::SectionStack(const QString& name, QWidget* parent) : QWidget(parent) {
    laidOut(column_, {}, gap::tiny, {tabs_});
    // By default the layout would demand enough height for all sections stacked.
    column_->setSizeConstraint(QLayout::SetNoConstraint);
    tabs_->setAccessibleName(name);
    tabs_->setExpanding(false);
    tabs_->setDrawBase(false);
    tabs_->setUsesScrollButtons(true);
    tabs_->hide();
    connect(tabs_, &QTabBar::currentChanged, this, &SectionStack::arrange);
}

void SectionStack::add(QLabel* title, QWidget* body, const QString& tab, int stretch) {
    sections_.push_back({title, body, tab});
    column_->addWidget(title);
    column_->addWidget(body, stretch);
    showTabs();
}

void SectionStack::change(const QWidget* body, bool Section::*part, bool value) {
    const auto found = std::ranges::find(sections_, body, &Section::body);
    if (found != sections_.end() && std::exchange((*found).*part, value) != value)
        showTabs();
}

void SectionStack::show(const QWidget* body) {
    for (int i = 0; i < tabs_->count(); ++i)
        if (sections_[tabs_->tabData(i).toUInt()].body == body)
            tabs_->setCurrentIndex(i);
}

/// Makes one tab for each shown section; the current section stays in front if possible.
void SectionStack::showTabs() {
    const QSignalBlocker quiet(tabs_);
    const int front = tabs_->currentIndex();
    const uint in_front = front < 0 ? 0 : tabs_->tabData(front).toUInt();
    while (tabs_->count() > 0)
        tabs_->removeTab(0);
    for (uint number = 0; number < sections_.size(); ++number) {
        const Section& section = sections_[number];
        if (!section.shown)
            continue;
        const int tab = tabs_->addTab(section.tab);
        tabs_->setTabData(tab, number);
        tabs_->setTabToolTip(tab, section.body->accessibleName());
        if (number == in_front)
            tabs_->setCurrentIndex(tab);
    }
    arrange();
}

void SectionStack::arrange() {
    const bool tabbed = height() < tabs_->count() * least_px && tabs_->count() > 1;
    tabs_->setVisible(tabbed);
    const int front = tabs_->currentIndex();
    for (uint number = 0; number < sections_.size(); ++number) {
        const Section& section = sections_[number];
        const bool in_front = front >= 0 && tabs_->tabData(front).toUInt() == number;
        const bool seen = section.shown && (!tabbed || in_front);
        section.title->setVisible(seen && (!tabbed || section.keeps_title));
        section.body->setVisible(seen);
    }
}

void SectionStack::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

} // namespace usar::widgets
