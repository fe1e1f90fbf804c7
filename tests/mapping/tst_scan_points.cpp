// The points of scans, as they are and as read back from PLY and LAS by readers that know only the formats.
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "core/mapping/scan_points.h"
#include "tests/suite/suite.h"

namespace tst_scan_points {

using namespace usar;
using namespace usar::mapping;

namespace {

constexpr double right_angle_rad = M_PI / 2.0;

/// Three beams from a scanner that looks down from 6 m: 90 degrees to the side, down, and 90 to the other side.
KeptScan scanAt(const Vec3& at_m, std::vector<float> ranges_m, double time_s, std::uint32_t scanner = 0) {
    KeptScan scan;
    scan.time = Seconds{time_s};
    scan.scanner_in_map = {.position_m = at_m, .pitch_rad = right_angle_rad};
    scan.scanner = scanner;
    scan.ranges_m = std::move(ranges_m);
    scan.resolution_rad = right_angle_rad;
    scan.fov_rad = 2.0 * right_angle_rad;
    return scan;
}

std::vector<KeptScan> twoScans() {
    return {scanAt({10.0, -4.0, 6.0}, {2.0f, 5.5f, 3.0f}, 12.25),
            scanAt({-11.0, -4.0, 6.0}, {20.0f, 6.0f, std::numeric_limits<float>::quiet_NaN()}, 90.5, 1)};
}

/// Points in the order of the file.
struct Point {
    Vec3 at_m = Vec3::Zero();
    double time_s = 0.0;
    double range_m = 0.0;
};

bool near(const Point& a, const Point& b) {
    return (a.at_m - b.at_m).norm() < 0.0011 && a.time_s == b.time_s && std::abs(a.range_m - b.range_m) < 1e-6;
}

/// The points of `twoScans`: beam 0 goes to the right (y is left), and of the second scan only the middle one hits.
const std::array<Point, 4> expected{{{{10.0, -6.0, 6.0}, 12.25, 2.0},
                                     {{10.0, -4.0, 0.5}, 12.25, 5.5},
                                     {{10.0, -1.0, 6.0}, 12.25, 3.0},
                                     {{-11.0, -4.0, 0.0}, 90.5, 6.0}}};

/// Takes numbers from the front of a file.
class Front {
public:
    explicit Front(std::string_view bytes) : bytes_(bytes) {}
    template <class Number>
    Number next() {
        Number number{}; // This machine is little-endian, as the files are.
        std::memcpy(&number, bytes_.data(), sizeof(Number));
        bytes_.remove_prefix(sizeof(Number));
        return number;
    }
    std::string text(std::size_t width) {
        const std::string field(bytes_.substr(0, width));
        bytes_.remove_prefix(width);
        return field.c_str();
    }
    void skip(std::size_t count) { bytes_.remove_prefix(count); }
    std::size_t left() const { return bytes_.size(); }

private:
    std::string_view bytes_;
};

using Write = bool (*)(std::span<const KeptScan>, const ByteSink&);

bool lasOfADay(std::span<const KeptScan> scans, const ByteSink& sink) {
    return writeLas(scans, {331, 2026}, sink);
}

std::string written(Write write, const std::vector<KeptScan>& scans) {
    std::string bytes;
    const bool sent = write(scans, [&bytes](const char* piece, std::size_t count) {
        bytes.append(piece, count);
        return true;
    });
    return sent ? bytes : "not sent";
}

std::vector<Point> readPly(const std::string& bytes) {
    const std::size_t body = bytes.find("end_header\n") + 11;
    const std::size_t at = bytes.find("element vertex ") + 15;
    Front front(std::string_view(bytes).substr(body));
    std::vector<Point> points(std::stoul(bytes.substr(at)));
    for (Point& point : points) {
        for (double& value_m : point.at_m)
            value_m = double(front.next<float>());
        point.time_s = front.next<double>();
        point.range_m = double(front.next<float>());
    }
    return front.left() == 0 ? points : std::vector<Point>{};
}

struct Las {
    std::uint32_t count = 0;
    std::array<double, 3> scale_m{}, offset_m{}, most_m{}, least_m{};
    std::vector<Point> points;
    std::vector<int> angles_deg, sources;
};

/// Reads what LAS 1.2 says, at the offsets that it says; empty if something is not as it says.
Las readLas(const std::string& bytes) {
    Las las;
    Front header(bytes);
    if (header.text(4) != "LASF")
        return las;
    header.skip(20);
    const int major = header.next<std::uint8_t>(), minor = header.next<std::uint8_t>();
    header.skip(64 + 4);
    const auto header_size = header.next<std::uint16_t>();
    const auto points_at = header.next<std::uint32_t>();
    const auto records = header.next<std::uint32_t>();
    const auto format = header.next<std::uint8_t>();
    const auto point_size = header.next<std::uint16_t>();
    las.count = header.next<std::uint32_t>();
    const auto first_returns = header.next<std::uint32_t>();
    header.skip(16);
    for (auto* axes : {&las.scale_m, &las.offset_m})
        for (double& value : *axes)
            value = header.next<double>();
    for (std::size_t i = 0; i < 3; ++i) {
        las.most_m[i] = header.next<double>();
        las.least_m[i] = header.next<double>();
    }
    if (major != 1 || minor != 2 || header_size != 227 || records != 1 || format != 1 || point_size != 32 ||
        first_returns != las.count || bytes.size() != points_at + las.count * point_size)
        return {};
    Front points(std::string_view(bytes).substr(points_at));
    for (std::uint32_t i = 0; i < las.count; ++i) {
        Point point;
        for (std::size_t axis = 0; axis < 3; ++axis)
            point.at_m[int(axis)] = points.next<std::int32_t>() * las.scale_m[axis] + las.offset_m[axis];
        points.skip(4);
        las.angles_deg.push_back(points.next<std::int8_t>());
        points.skip(1);
        las.sources.push_back(points.next<std::uint16_t>());
        point.time_s = points.next<double>();
        point.range_m = double(points.next<float>());
        las.points.push_back(point);
    }
    return las;
}

} // namespace

class tst_ScanPoints : public QObject {
    Q_OBJECT
private slots:
    void plyReadsBack() {
        const std::string bytes = written(writePly, twoScans());
        QVERIFY(bytes.starts_with("ply\nformat binary_little_endian 1.0\n"));
        const std::vector<Point> points = readPly(bytes);
        QVERIFY(std::ranges::equal(points, expected, near));
    }

    void plyNamesItsProperties() {
        const std::string bytes = written(writePly, twoScans());
        std::size_t at = 0;
        for (const char* const line : {"element vertex 4\n", "property float x\n", "property float y\n",
                                       "property float z\n", "property double time\n", "property float range\n"}) {
            at = bytes.find(line, at);
            QVERIFY2(at != std::string::npos, line);
        }
    }

    void lasReadsBack() {
        const Las las = readLas(written(lasOfADay, twoScans()));
        QCOMPARE(las.count, 4u);
        QVERIFY(std::ranges::equal(las.points, expected, near));
        QCOMPARE(las.angles_deg, (std::vector<int>{-90, 0, 90, 0}));
        QCOMPARE(las.sources, (std::vector<int>{1, 1, 1, 2}));
        const std::array<double, 3> least_m{-11.0, -6.0, 0.0}, most_m{10.0, -1.0, 6.0};
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(las.scale_m[i], 0.001);
            QVERIFY(std::abs(las.least_m[i] - least_m[i]) < 1e-3 && std::abs(las.most_m[i] - most_m[i]) < 1e-3);
        }
    }

    void lasSaysWhoWroteItAndWhatTheExtraBytesAre() {
        const std::string bytes = written(lasOfADay, twoScans());
        Front front(bytes);
        front.skip(26);
        QCOMPARE(front.text(32), std::string("USARSim range scanner"));
        QCOMPARE(front.text(32), std::string("USAR Mission Control"));
        QCOMPARE(front.next<std::uint16_t>(), 331);
        QCOMPARE(front.next<std::uint16_t>(), 2026);
        QCOMPARE(front.next<std::uint16_t>(), 227);
        QCOMPARE(front.next<std::uint32_t>(), 227u + 54u + 192u);
        Front record(std::string_view(bytes).substr(227));
        record.skip(2);
        QCOMPARE(record.text(16), std::string("LASF_Spec"));
        QCOMPARE(record.next<std::uint16_t>(), 4);
        QCOMPARE(record.next<std::uint16_t>(), 192);
        record.skip(32 + 2);
        QCOMPARE(record.next<std::uint8_t>(), 9); // float
        QCOMPARE(record.next<std::uint8_t>(), 0);
        QCOMPARE(record.text(32), std::string("range"));
        record.skip(124);
        QCOMPARE(record.text(32), std::string("from the scanner, in meters"));
    }

    void aWorldTooLargeForMillimetersGetsACoarserScale() {
        const double far_m = 3e6;
        const Las las = readLas(written(lasOfADay, {scanAt({0.0, 0.0, 6.0}, {2.0f, 5.5f, 3.0f}, 1.0),
                                                    scanAt({far_m, 0.0, 6.0}, {9.f, 6.f, 9.f}, 2.0)}));
        QCOMPARE(las.count, 6u);
        QCOMPARE(las.scale_m[0], 0.01);
        QCOMPARE(las.scale_m[1], 0.001);
        QVERIFY(std::abs(las.points[4].at_m.x() - far_m) < 0.006);
    }

    void scansWithoutHitsGiveFilesWithoutPoints() {
        for (const auto& scans : {std::vector<KeptScan>{},
                                  {scanAt({0, 0, 6}, {20.0f, 19.99f, 0.0f}, 1.0)},
                                  {scanAt({NAN, 0, 6}, {2.0f, 2.0f, 2.0f}, 1.0)}}) {
            QVERIFY(written(writePly, scans).ends_with("end_header\n"));
            const std::string bytes = written(lasOfADay, scans);
            QCOMPARE(bytes.size(), std::size_t(473));
            const Las las = readLas(bytes);
            QCOMPARE(las.count, 0u);
            QCOMPARE(las.scale_m[0], 0.001);
        }
    }

    void aFullDiskStopsTheWriting_data() {
        QTest::addColumn<int>("pieces_taken");
        QTest::newRow("before the header") << 0;
        QTest::newRow("behind the header") << 1;
        QTest::newRow("in the middle") << 2;
    }

    void aFullDiskStopsTheWriting() {
        QFETCH(int, pieces_taken);
        const std::vector<KeptScan> scans(40'000, twoScans().front());
        for (const Write write : {Write(writePly), Write(lasOfADay)}) {
            int pieces = 0;
            QVERIFY(!write(scans, [&](const char*, std::size_t) { return pieces++ < pieces_taken; }));
            QCOMPARE(pieces, pieces_taken + 1);
        }
    }
};

USAR_TEST(tst_ScanPoints)

} // namespace tst_scan_points

#include "tst_scan_points.moc"
