// Sections with titles, stacked if there is room for all of them, else shown one at a time with tabs.
#pragma once

#include <vector>

#include <QLabel>
#include <QTabBar>
#include <QVBoxLayout>
#include <QWidget>

namespace usar::widgets {

/// Each section gets at least `least_px` or is moved to a tab, because a section with half a visible row is useless.
/// Hidden sections have neither room nor tab. GUI thread.
class SectionStack : public QWidget {
    Q_OBJECT
public:
    static constexpr int least_px = 88; ///< height of a title and three rows

    /// `name` is the accessible name of the tab bar.
    explicit SectionStack(const QString& name, QWidget* parent = nullptr);

    /// Appends a section and takes ownership of both widgets. Stacked sections share the room in proportion to
    /// `stretch`.
    void add(QLabel* title, QWidget* body, const QString& tab, int stretch);
    /// An unknown `body` changes nothing, here and below.
    void setSectionShown(const QWidget* body, bool shown) { change(body, &Section::shown, shown); }
    /// Keeps the section's title visible even with tabs, because it says more than the tab.
    void setTitleKept(const QWidget* body, bool kept) { change(body, &Section::keeps_title, kept); }
    /// Brings this section to the front; has a visible effect only with tabs.
    void show(const QWidget* body);
    using QWidget::show;

    QSize minimumSizeHint() const override { return {120, least_px + 24}; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Section {
        QLabel* title = nullptr;
        QWidget* body = nullptr;
        QString tab;
        bool shown = true;
        bool keeps_title = false;
    };
    /// Changes one part of this body's section.
    void change(const QWidget* body, bool Section::*part, bool value);
    /// Switches between stacked sections and tabs, depending on the height.
    void arrange();
    /// Makes a tab for each shown section.
    void showTabs();

    std::vector<Section> sections_;
    QVBoxLayout* column_ = new QVBoxLayout(this);
    QTabBar* tabs_ = new QTabBar(this); ///< one per shown section; the tab's data is the index in `sections_`
};

} // namespace usar::widgets
