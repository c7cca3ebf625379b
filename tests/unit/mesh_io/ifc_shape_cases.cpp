#include "tests/unit/mesh_io/ifc_shape_cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace rubicon::mesh_io::testing {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Area of a regular polygon in a circle of radius 1.
double polygon_area(int corners) { return corners / 2.0 * std::sin(2 * kPi / corners); }

/// Circles below 0.26 m of radius have 36 corners.
const double kPi36 = polygon_area(36);

std::string extruded(const std::string& profile, double depth) {
  return fmt::format("#100= IFCEXTRUDEDAREASOLID(#101,#4,#6,{:.6f});\n#101= {};\n", depth, profile);
}

/// The outline of an area, as an IfcPolyline with its points.
std::string polyline(int id, const std::vector<std::pair<double, double>>& points) {
  std::string records;
  std::string list;
  int next = id + 1;
  for (const auto& [x, y] : points) {
    records += fmt::format("#{}= IFCCARTESIANPOINT(({:.6f},{:.6f}));\n", next, x, y);
    list += fmt::format("#{},", next++);
  }
  return records + fmt::format("#{}= IFCPOLYLINE(({}#{}));\n", id, list, id + 1);
}

/// A block with its lowest corner at (x, y, z), as extrusion `id`.
std::string block(int id, double x, double y, double z, double dx, double dy, double dz) {
  return fmt::format(
             "#{0}= IFCEXTRUDEDAREASOLID(#{1},#{2},#6,{3:.6f});\n"
             "#{2}= IFCAXIS2PLACEMENT3D(#{4},$,$);\n"
             "#{4}= IFCCARTESIANPOINT((0.,0.,{5:.6f}));\n"
             "#{1}= IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#{6});\n",
             id, id + 1, id + 2, dz, id + 3, z, id + 4) +
         polyline(id + 4, {{x, y}, {x + dx, y}, {x + dx, y + dy}, {x, y + dy}});
}

/// The faces of a block between two corners, as a closed shell; inside out with `inwards`.
std::string shell(int id, double low, double high, bool inwards) {
  constexpr int kFaces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::string records;
  for (int k = 0; k < 8; ++k) {
    const double x = k % 4 == 1 || k % 4 == 2 ? high : low;
    const double y = k % 4 >= 2 ? high : low;
    records += fmt::format("#{}= IFCCARTESIANPOINT(({:.3f},{:.3f},{:.3f}));\n", id + 1 + k, x, y,
                           k >= 4 ? high : low);
  }
  std::string faces;
  int next = id + 10;
  for (const auto& f : kFaces) {
    records += fmt::format(
        "#{}= IFCPOLYLOOP((#{},#{},#{},#{}));\n#{}= IFCFACEOUTERBOUND(#{},.{}.);\n"
        "#{}= IFCFACE((#{}));\n",
        next, id + 1 + f[0], id + 1 + f[1], id + 1 + f[2], id + 1 + f[3], next + 1, next,
        inwards ? "F" : "T", next + 2, next + 1);
    faces += fmt::format("{}#{}", faces.empty() ? "" : ",", next + 2);
    next += 3;
  }
  return records + fmt::format("#{}= IFCCLOSEDSHELL(({}));\n", id, faces);
}

/// A wall of 4 m x 0.2 m x 3 m.
std::string wall(int id = 100) { return block(id, 0, 0, 0, 4000, 200, 3000); }

/// A plane half space: what lies on the side of (x, y, z) from the point, or against it.
std::string half_space(int id, const std::string& at, const std::string& way, bool along) {
  return fmt::format(
      "#{0}= IFCHALFSPACESOLID(#{1},.{2}.);\n#{1}= IFCPLANE(#{3});\n"
      "#{3}= IFCAXIS2PLACEMENT3D(#{4},#{5},$);\n#{4}= IFCCARTESIANPOINT(({6}));\n"
      "#{5}= IFCDIRECTION(({7}));\n",
      id, id + 1, along ? "F" : "T", id + 2, id + 3, id + 4, at, way);
}

std::vector<ShapeCase> profiles() {
  const geometry::Vec3 lower(-0.06, -0.04, 0);
  return {
      {"hollow rectangle",
       extruded("IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,#12,120.,80.,5.,$,$)", 2500),
       "",
       (120 * 80 - 110 * 70) * 2.5e-6,
       {0.12, 0.08, 2.5},
       lower},
      {"hollow rectangle with round corners",
       extruded("IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,#12,120.,80.,5.,5.,10.)", 2500),
       "",
       (120 * 80 - (4 - kPi36) * 100 - 110 * 70 + (4 - kPi36) * 25) * 2.5e-6,
       {0.12, 0.08, 2.5},
       lower},
      {"pipe",
       extruded("IFCCIRCLEHOLLOWPROFILEDEF(.AREA.,$,#12,100.,10.)", 2000),
       "",
       kPi36 * (100 * 100 - 90 * 90) * 2e-6,
       {0.2, 0.2, 2},
       {-0.1, -0.1, 0}},
      {"round column of 1 m radius",
       extruded("IFCCIRCLEPROFILEDEF(.AREA.,$,#12,1000.)", 2000),
       "",
       polygon_area(72) * 2,
       {2, 2, 2},
       {-1, -1, 0}},
      {"rounded rectangle",
       extruded("IFCROUNDEDRECTANGLEPROFILEDEF(.AREA.,$,#12,120.,80.,20.)", 1000),
       "",
       (9600 - (4 - kPi36) * 400) * 1e-6,
       {0.12, 0.08, 1},
       lower},
      {"ellipse",
       extruded("IFCELLIPSEPROFILEDEF(.AREA.,$,#12,200.,100.)", 1000),
       "",
       kPi36 * 0.02,
       {0.4, 0.2, 1},
       {-0.2, -0.1, 0}},
      {"I with fillets",
       extruded("IFCISHAPEPROFILEDEF(.AREA.,$,#12,100.,200.,6.,9.,12.)", 1000),
       "",
       (2 * 100 * 9 + 182 * 6 + (4 - kPi36) * 144) * 1e-6,
       {0.1, 0.2, 1},
       {-0.05, -0.1, 0}},
      {"L with round edges",
       extruded("IFCLSHAPEPROFILEDEF(.AREA.,$,#12,100.,100.,10.,12.,6.,$)", 1000),
       "",
       (1900 + (1 - kPi36 / 4) * (144 - 2 * 36)) * 1e-6,
       {0.1, 0.1, 1},
       {-0.05, -0.05, 0}},
      {"slab with two shafts",
       "#100= IFCEXTRUDEDAREASOLID(#101,#4,#6,200.);\n"
       "#101= IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$,#110,(#120,#130));\n" +
           polyline(110, {{0, 0}, {6000, 0}, {6000, 4000}, {0, 4000}}) +
           polyline(120, {{1000, 1000}, {2000, 1000}, {2000, 2500}, {1000, 2500}}) +
           polyline(130, {{4000, 3000}, {4500, 3500}, {4000, 3500}}),
       "",
       (24 - 1.5 - 0.125) * 0.2,
       {6, 4, 0.2},
       {0, 0, 0}},
      {"slot of lines and arcs",
       "#100= IFCEXTRUDEDAREASOLID(#101,#4,#6,1000.);\n"
       "#101= IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#102);\n"
       "#102= IFCCOMPOSITECURVE((#103,#104,#105,#106),.F.);\n"
       "#103= IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#110);\n"
       "#104= IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#120);\n"
       "#105= IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.F.,#130);\n"
       "#106= IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#140);\n"
       "#110= IFCPOLYLINE((#111,#112));\n#111= IFCCARTESIANPOINT((0.,-100.));\n"
       "#112= IFCCARTESIANPOINT((500.,-100.));\n"
       "#120= IFCTRIMMEDCURVE(#121,(IFCPARAMETERVALUE(-1.5707963267948966)),"
       "(IFCPARAMETERVALUE(1.5707963267948966)),.T.,.PARAMETER.);\n"
       "#121= IFCCIRCLE(#122,100.);\n#122= IFCAXIS2PLACEMENT2D(#123,$);\n"
       "#123= IFCCARTESIANPOINT((500.,0.));\n"
       "#130= IFCPOLYLINE((#131,#132));\n#131= IFCCARTESIANPOINT((0.,100.));\n"
       "#132= IFCCARTESIANPOINT((500.,100.));\n"
       "#140= IFCTRIMMEDCURVE(#141,(#131),(#111),.T.,.CARTESIAN.);\n#141= IFCCIRCLE(#12,100.);\n",
       "",
       0.1 + kPi36 * 0.01,
       {0.7, 0.2, 1},
       {-0.1, -0.1, 0}},
      {"profile composed of a pipe and a plate",
       "#100= IFCEXTRUDEDAREASOLID(#101,#4,#6,1000.);\n"
       "#101= IFCCOMPOSITEPROFILEDEF(.AREA.,$,(#102,#103),$);\n"
       "#102= IFCCIRCLEHOLLOWPROFILEDEF(.AREA.,$,#12,100.,10.);\n"
       "#103= IFCDERIVEDPROFILEDEF(.AREA.,$,#104,#105,$);\n"
       "#104= IFCRECTANGLEPROFILEDEF(.AREA.,$,#12,100.,20.);\n"
       "#105= IFCCARTESIANTRANSFORMATIONOPERATOR2D($,$,#106,2.);\n"
       "#106= IFCCARTESIANPOINT((200.,0.));\n",
       "",
       kPi36 * 1900e-6 + 0.008,
       {0.4, 0.2, 1},
       {-0.1, -0.1, 0}},
      {"oblique extrusion",
       "#100= IFCEXTRUDEDAREASOLID(#101,#4,#102,5000.);\n#102= IFCDIRECTION((3.,0.,4.));\n"
       "#101= IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,#12,200.,200.,10.,$,$);\n",
       "",
       (0.04 - 0.0324) * 4,
       {3.2, 0.2, 4},
       {-0.1, -0.1, 0}},
  };
}

std::vector<ShapeCase> cuts() {
  return {
      {"wall under a sloping roof",
       "#100= IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#200,#300);\n" + wall(200) +
           half_space(300, "0.,0.,2000.", "-1.,0.,4.", true),
       "",
       0.2 * 4 * 2.5,
       {4, 0.2, 3},
       {0, 0, 0}},
      {"pipe cut at both ends",
       "#100= IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#101,#300);\n"
       "#101= IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#200,#400);\n"
       "#200= IFCEXTRUDEDAREASOLID(#201,#4,#6,2000.);\n"
       "#201= IFCCIRCLEHOLLOWPROFILEDEF(.AREA.,$,#12,100.,10.);\n" +
           half_space(300, "0.,0.,1500.", "1.,0.,1.", true) +
           half_space(400, "0.,0.,500.", "1.,0.,1.", false),
       "",
       kPi36 * 1900e-6 * 1,
       {0.2, 0.2, 1.2},
       {-0.1, -0.1, 0.4}},
      {"gable cut by a bounded half space",
       "#100= IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#200,#300);\n" + wall(200) +
           "#300= IFCPOLYGONALBOUNDEDHALFSPACE(#301,.F.,#4,#310);\n#301= IFCPLANE(#302);\n"
           "#302= IFCAXIS2PLACEMENT3D(#303,#304,$);\n#303= IFCCARTESIANPOINT((0.,0.,2000.));\n"
           "#304= IFCDIRECTION((0.,0.,1.));\n" +
           polyline(310, {{1000, -500}, {2000, -500}, {2000, 500}, {1000, 500}}),
       "",
       2.4 - 0.2,
       {4, 0.2, 3},
       {0, 0, 0}},
      {"two blocks, one out of the other",
       "#100= IFCBOOLEANRESULT(.DIFFERENCE.,#200,#300);\n" + wall(200) +
           block(300, 1000, -100, 1000, 1000, 200, 1000),
       "",
       2.4 - 0.1,
       {4, 0.2, 3},
       {0, 0, 0}},
      {"what two blocks share",
       "#100= IFCBOOLEANRESULT(.INTERSECTION.,#200,#300);\n" + wall(200) +
           block(300, 3000, -100, 1000, 5000, 200, 1000),
       "",
       0.1,
       {1, 0.1, 1},
       {3, 0, 1}},
      {"two blocks side by side",
       "#100= IFCBOOLEANRESULT(.UNION.,#200,#300);\n" + wall(200) +
           block(300, 5000, 0, 0, 1000, 200, 1000),
       "",
       2.6,
       {6, 0.2, 3},
       {0, 0, 0}},
      {"block with a round hole",
       "#100= IFCCSGSOLID(#101);\n#101= IFCBOOLEANRESULT(.DIFFERENCE.,#102,#103);\n"
       "#102= IFCBLOCK(#4,1000.,1000.,200.);\n#103= IFCRIGHTCIRCULARCYLINDER(#104,300.,200.);\n"
       "#104= IFCAXIS2PLACEMENT3D(#105,$,$);\n#105= IFCCARTESIANPOINT((500.,500.,-50.));\n",
       "",
       0.2 - kPi36 * 0.04 * 0.2,
       {1, 1, 0.2},
       {0, 0, 0}},
      {"chain of three cuts",
       "#100= IFCBOOLEANRESULT(.DIFFERENCE.,#101,#300);\n"
       "#101= IFCBOOLEANRESULT(.DIFFERENCE.,#102,#400);\n"
       "#102= IFCBOOLEANRESULT(.DIFFERENCE.,#200,#500);\n" +
           wall(200) + block(300, 500, -100, 0, 1000, 400, 2000) +
           block(400, 1000, -100, 1000, 1000, 400, 1500) +
           block(500, 3000, 100, 500, 500, 200, 500),
       "",
       2.4 - 0.4 - (1.5 - 0.5) * 0.2 - 0.025,
       {4, 0.2, 3},
       {0, 0, 0}},
  };
}

std::vector<ShapeCase> openings() {
  const geometry::Vec3 size(4, 0.2, 3);
  const geometry::Vec3 zero = geometry::Vec3::Zero();
  return {
      {"window", wall() + block(200, 1000, -100, 1000, 1200, 400, 1000), "#200", 2.4 - 0.24, size,
       zero},
      {"window as deep as the wall", wall() + block(200, 1000, 0, 1000, 1200, 200, 1000), "#200",
       2.4 - 0.24, size, zero},
      {"door down to the floor", wall() + block(200, 1000, -100, 0, 900, 400, 2100), "#200",
       2.4 - 0.2 * 0.9 * 2.1, size, zero},
      {"niche", wall() + block(200, 1000, 0, 1000, 1000, 120, 1000), "#200", 2.4 - 0.12, size,
       zero},
      {"recess over the end of the wall", wall() + block(200, 3500, -50, 1000, 1000, 300, 1000),
       "#200", 2.4 - 0.1, size, zero},
      {"two windows that overlap",
       wall() + block(200, 1000, -100, 1000, 1000, 400, 1000) +
           block(300, 1500, -100, 1500, 1000, 400, 1000),
       "#200,#300", 2.4 - 0.2 * 1.75, size, zero},
      {"two windows side by side",
       wall() + block(200, 500, -100, 1000, 1000, 400, 1000) +
           block(300, 1500, -100, 1000, 1000, 400, 1000),
       "#200,#300", 2.4 - 0.4, size, zero},
      {"opening beside the wall", wall() + block(200, 5000, 0, 0, 1000, 200, 1000), "#200", 2.4,
       size, zero},
      {"round opening across the wall",
       wall() + "#200= IFCEXTRUDEDAREASOLID(#201,#202,#6,400.);\n"
                "#201= IFCCIRCLEPROFILEDEF(.AREA.,$,#12,200.);\n"
                "#202= IFCAXIS2PLACEMENT3D(#203,#8,#7);\n"
                "#203= IFCCARTESIANPOINT((2000.,-100.,1500.));\n",
       "#200", 2.4 - kPi36 * 0.04 * 0.2, size, zero},
      {"L-shaped opening",
       wall() +
           "#200= IFCEXTRUDEDAREASOLID(#201,#202,#6,400.);\n"
           "#201= IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#210);\n"
           "#202= IFCAXIS2PLACEMENT3D(#203,#204,#7);\n#204= IFCDIRECTION((0.,-1.,0.));\n"
           "#203= IFCCARTESIANPOINT((0.,300.,0.));\n" +
           polyline(
               210,
               {{1000, 500}, {3000, 500}, {3000, 1000}, {1500, 1000}, {1500, 2500}, {1000, 2500}}),
       "#200", 2.4 - 0.2 * (1 + 0.75), size, zero},
      {"slanting opening",
       wall() + "#200= IFCEXTRUDEDAREASOLID(#201,#202,#204,4000.);\n"
                "#201= IFCRECTANGLEPROFILEDEF(.AREA.,$,#12,100.,1000.);\n"
                "#202= IFCAXIS2PLACEMENT3D(#203,$,$);\n#204= IFCDIRECTION((3.,0.,4.));\n"
                "#203= IFCCARTESIANPOINT((1000.,100.,-100.));\n",
       "#200", 2.4 - 0.1 * 0.2 * 3, size, zero},
      {"opening that leaves nothing of a pier",
       wall() + block(200, -100, -100, 500, 5000, 400, 1000), "#200", 1.6, size, zero},
  };
}

std::vector<ShapeCase> bodies() {
  const double step = 2 * kPi / 36;
  const double chord36 = 18 * std::sin(step);  // area of the circle's polygon over radius squared
  return {
      {"brep with a void",
       "#100= IFCFACETEDBREPWITHVOIDS(#200,(#300));\n" + shell(200, 0, 2000, false) +
           shell(300, 500, 1500, false),
       "",
       7,
       {2, 2, 2},
       {0, 0, 0}},
      {"brep inside out",
       "#100= IFCFACETEDBREP(#200);\n" + shell(200, 0, 1000, true),
       "",
       1,
       {1, 1, 1},
       {0, 0, 0}},
      {"brep with an opening",
       "#100= IFCFACETEDBREP(#200);\n" + shell(200, 0, 1000, false) +
           block(300, 250, 250, -100, 500, 500, 2000),
       "#300",
       0.75,
       {1, 1, 1},
       {0, 0, 0}},
      {"quarter of a ring",
       "#100= IFCREVOLVEDAREASOLID(#101,#4,#102,1.5707963267948966);\n"
       "#101= IFCRECTANGLEPROFILEDEF(.AREA.,$,#103,50.,100.);\n"
       "#103= IFCAXIS2PLACEMENT2D(#104,$);\n#104= IFCCARTESIANPOINT((175.,0.));\n"
       "#102= IFCAXIS1PLACEMENT(#3,#8);\n",
       "",
       chord36 / 4 * (0.2 * 0.2 - 0.15 * 0.15) * 0.1,
       {0.2, 0.1, 0.2},
       {0, -0.05, -0.2}},
      {"ring",
       "#100= IFCREVOLVEDAREASOLID(#101,#4,#102,6.283185307179586);\n"
       "#101= IFCRECTANGLEPROFILEDEF(.AREA.,$,#103,50.,100.);\n"
       "#103= IFCAXIS2PLACEMENT2D(#104,$);\n#104= IFCCARTESIANPOINT((175.,0.));\n"
       "#102= IFCAXIS1PLACEMENT(#3,#8);\n",
       "",
       chord36 * (0.2 * 0.2 - 0.15 * 0.15) * 0.1,
       {0.4, 0.1, 0.4},
       {-0.2, -0.05, -0.2}},
      {"disc that is turned about its side",
       "#100= IFCREVOLVEDAREASOLID(#101,#4,#102,6.283185307179586);\n"
       "#101= IFCRECTANGLEPROFILEDEF(.AREA.,$,#103,200.,100.);\n"
       "#103= IFCAXIS2PLACEMENT2D(#104,$);\n#104= IFCCARTESIANPOINT((100.,0.));\n"
       "#102= IFCAXIS1PLACEMENT(#3,#8);\n",
       "",
       chord36 * 0.04 * 0.1,
       {0.4, 0.1, 0.4},
       {-0.2, -0.05, -0.2}},
      {"handrail with a corner",
       "#100= IFCSWEPTDISKSOLID(#101,20.,$,$,$);\n#101= IFCPOLYLINE((#3,#102,#103));\n"
       "#102= IFCCARTESIANPOINT((0.,0.,1000.));\n#103= IFCCARTESIANPOINT((2000.,0.,1000.));\n",
       "",
       kPi36 * 400e-6 * 3,
       {2.02, 0.04, 1.02},
       {-0.02, -0.02, 0}},
      {"bent pipe",
       "#100= IFCSWEPTDISKSOLID(#101,20.,15.,$,$);\n#101= IFCPOLYLINE((#3,#102,#103));\n"
       "#102= IFCCARTESIANPOINT((0.,0.,1000.));\n#103= IFCCARTESIANPOINT((2000.,0.,1000.));\n",
       "",
       kPi36 * (400 - 225) * 1e-6 * 3,
       {2.02, 0.04, 1.02},
       {-0.02, -0.02, 0}},
      {"block",
       "#100= IFCCSGSOLID(#101);\n#101= IFCBLOCK(#4,1000.,2000.,3000.);\n",
       "",
       6,
       {1, 2, 3},
       {0, 0, 0}},
      {"pyramid",
       "#100= IFCCSGSOLID(#101);\n#101= IFCRECTANGULARPYRAMID(#4,1000.,2000.,3000.);\n",
       "",
       2,
       {1, 2, 3},
       {0, 0, 0}},
      {"cylinder",
       "#100= IFCCSGSOLID(#101);\n#101= IFCRIGHTCIRCULARCYLINDER(#4,1000.,200.);\n",
       "",
       kPi36 * 0.04,
       {0.4, 0.4, 1},
       {-0.2, -0.2, 0}},
      {"cone",
       "#100= IFCCSGSOLID(#101);\n#101= IFCRIGHTCIRCULARCONE(#4,900.,200.);\n",
       "",
       kPi36 * 0.04 * 0.3,
       {0.4, 0.4, 0.9},
       {-0.2, -0.2, 0}},
      {"mapped twice, once mirrored and twice as large",
       "#100= IFCMAPPEDITEM(#101,#110);\n#101= IFCREPRESENTATIONMAP(#4,#102);\n"
       "#102= IFCSHAPEREPRESENTATION(#5,'Body','x',(#103,#104));\n"
       "#103= IFCMAPPEDITEM(#105,#111);\n#105= IFCREPRESENTATIONMAP(#4,#106);\n"
       "#106= IFCSHAPEREPRESENTATION(#5,'Body','x',(#200));\n#104= IFCMAPPEDITEM(#105,#110);\n"
       "#110= IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#3,1.,$);\n"
       "#111= IFCCARTESIANTRANSFORMATIONOPERATOR3D(#7,#112,#113,2.,#6);\n"
       "#112= IFCDIRECTION((0.,-1.,0.));\n#113= IFCCARTESIANPOINT((0.,-1000.,0.));\n" +
           block(200, 0, 0, 0, 1000, 500, 250),
       "",
       0.125 * 9,
       {2, 2.5, 0.5},
       {0, -2, 0}},
  };
}

}  // namespace

std::vector<ShapeCase> shape_cases() {
  std::vector<ShapeCase> all;
  for (auto* part : {profiles, cuts, openings, bodies}) {
    for (ShapeCase& each : part()) all.push_back(std::move(each));
  }
  return all;
}

std::string ifc_of(const std::string& records, const std::string& openings) {
  std::string text =
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');"
      "\n"
      "FILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n"
      "#1= IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);\n#2= IFCUNITASSIGNMENT((#1));\n"
      "#3= IFCCARTESIANPOINT((0.,0.,0.));\n#4= IFCAXIS2PLACEMENT3D(#3,$,$);\n"
      "#5= IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#4,$);\n"
      "#6= IFCDIRECTION((0.,0.,1.));\n#7= IFCDIRECTION((1.,0.,0.));\n"
      "#8= IFCDIRECTION((0.,1.,0.));\n"
      "#9= IFCPROJECT('0project00000000000000',$,'P',$,$,$,$,(#5),#2);\n"
      "#10= IFCCARTESIANPOINT((0.,0.));\n#12= IFCAXIS2PLACEMENT2D(#10,$);\n"
      "#11= IFCLOCALPLACEMENT($,#4);\n"
      "#20= IFCWALL('0wall00000000000000000',$,'wall',$,$,#11,#21,$,$);\n"
      "#21= IFCPRODUCTDEFINITIONSHAPE($,$,(#22));\n"
      "#22= IFCSHAPEREPRESENTATION(#5,'Body','x',(#100));\n";
  int id = 30;
  std::size_t at = 0;
  while (at < openings.size()) {
    const std::size_t end = std::min(openings.find(',', at), openings.size());
    text += fmt::format(
        "#{0}= IFCOPENINGELEMENT('0opening0000000000000{0}',$,'hole',$,$,#11,#{1},$,$);\n"
        "#{1}= IFCPRODUCTDEFINITIONSHAPE($,$,(#{2}));\n"
        "#{2}= IFCSHAPEREPRESENTATION(#5,'Body','x',({3}));\n"
        "#{4}= IFCRELVOIDSELEMENT('0voids000000000000000{0}',$,$,$,#20,#{0});\n",
        id, id + 1, id + 2, openings.substr(at, end - at), id + 3);
    id += 4;
    at = end + 1;
  }
  return text + records + "ENDSEC;\nEND-ISO-10303-21;\n";
}

}  // namespace rubicon::mesh_io::testing
