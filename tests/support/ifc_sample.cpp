#include "tests/support/ifc_sample.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace rubicon::testing {

namespace {

using Point = std::array<double, 3>;

constexpr int kFaces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                              {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

class SampleWriter {
 public:
  explicit SampleWriter(const IfcSample& sample) : sample_(sample) {
    if (sample.unit == "m") per_metre_ = 1;
    if (sample.unit == "ft") per_metre_ = 1 / 0.3048;
  }

  std::string write() {
    write_frame();
    write_storeys();
    std::vector<std::string> in_storey(sample_.storeys.size());
    for (std::size_t i = 0; i < sample_.blocks.size(); ++i) {
      std::string& list = in_storey[static_cast<std::size_t>(sample_.blocks[i].storey)];
      list += (list.empty() ? "" : ",") + write_block(i);
    }
    for (std::size_t i = 0; i < in_storey.size(); ++i) {
      if (in_storey[i].empty()) continue;
      add("IFCRELCONTAINEDINSPATIALSTRUCTURE('contained{}',{},$,$,({}),{})", i, owner_,
          in_storey[i], storeys_[i]);
    }
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
           "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('" +
           sample_.schema + "'));\nENDSEC;\nDATA;\n" + text_ + sample_.more +
           "ENDSEC;\nEND-ISO-10303-21;\n";
  }

 private:
  template <class... Arguments>
  std::string add(fmt::format_string<Arguments...> form, Arguments&&... arguments) {
    text_ += fmt::format("#{}= {};\n", ++last_,
                         fmt::format(form, std::forward<Arguments>(arguments)...));
    return fmt::format("#{}", last_);
  }

  static std::string real(double value) { return fmt::format("{:#.15g}", value); }

  std::string numbers(const Point& p) const {
    return fmt::format("({},{},{})", real(p[0] * per_metre_), real(p[1] * per_metre_),
                       real(p[2] * per_metre_));
  }

  std::string point(const Point& p) { return add("IFCCARTESIANPOINT({})", numbers(p)); }

  std::string placement(const Point& p, const std::string& relative_to) {
    const std::string axes = add("IFCAXIS2PLACEMENT3D({},$,$)", point(p));
    return add("IFCLOCALPLACEMENT({},{})", relative_to, axes);
  }

  void write_frame() {
    const std::string person = add("IFCPERSON($,$,'a',$,$,$,$,$)");
    const std::string firm = add("IFCORGANIZATION($,'o',$,$,$)");
    const std::string both = add("IFCPERSONANDORGANIZATION({},{},$)", person, firm);
    const std::string program = add("IFCAPPLICATION({},'1','x','x')", firm);
    const std::string owner = add("IFCOWNERHISTORY({},{},$,.ADDED.,$,$,$,0)", both, program);
    owner_ = sample_.owner_history ? owner : "$";
    const std::string unit = write_unit();
    const std::string units = add("IFCUNITASSIGNMENT(({}))", unit);
    const std::string world = add("IFCAXIS2PLACEMENT3D({},$,$)", point({0, 0, 0}));
    context_ = add("IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.0E-5,{},$)", world);
    up_ = add("IFCDIRECTION((0.,0.,1.))");
    project_ = add("IFCPROJECT('project',{},'P',$,$,$,$,({}),{})", owner_, context_, units);
  }

  std::string write_unit() {
    if (sample_.unit == "mm") return add("IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.)");
    const std::string metre = add("IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)");
    if (sample_.unit == "m") return metre;
    const std::string dimensions = add("IFCDIMENSIONALEXPONENTS(1,0,0,0,0,0,0)");
    const std::string foot = add("IFCMEASUREWITHUNIT(IFCLENGTHMEASURE(0.3048),{})", metre);
    return add("IFCCONVERSIONBASEDUNIT({},.LENGTHUNIT.,'FOOT',{})", dimensions, foot);
  }

  void write_storeys() {
    const std::string at_site = placement(sample_.site, "$");
    const std::string site =
        add("IFCSITE('site',{},'Site',$,$,{},$,$,.ELEMENT.,$,$,$,$,$)", owner_, at_site);
    const std::string at_building = placement({0, 0, 0}, at_site);
    const std::string building =
        add("IFCBUILDING('building',{},'B',$,$,{},$,$,.ELEMENT.,$,$,$)", owner_, at_building);
    std::string list;
    for (std::size_t i = 0; i < sample_.storeys.size(); ++i) {
      storey_places_.push_back(placement({0, 0, 0}, at_building));
      storeys_.push_back(add("IFCBUILDINGSTOREY('storey{}',{},'{}',$,$,{},$,$,.ELEMENT.,{})", i,
                             owner_, sample_.storeys[i], storey_places_.back(),
                             real(3.0 * static_cast<double>(i) * per_metre_)));
      list += (i == 0 ? "" : ",") + storeys_.back();
    }
    add("IFCRELAGGREGATES('a1',{},$,$,{},({}))", owner_, project_, site);
    add("IFCRELAGGREGATES('a2',{},$,$,{},({}))", owner_, site, building);
    add("IFCRELAGGREGATES('a3',{},$,$,{},({}))", owner_, building, list);
  }

  std::string write_block(std::size_t index) {
    const SampleBlock& block = sample_.blocks[index];
    const std::string item = write_item(block);
    const std::string body =
        add("IFCSHAPEREPRESENTATION({},'Body','Whatever',({}))", context_, item);
    const std::string shape = add("IFCPRODUCTDEFINITIONSHAPE($,$,({}))", body);
    const std::string at =
        placement(block.at, storey_places_[static_cast<std::size_t>(block.storey)]);
    return add("{}('{}',{},'{}',$,$,{},{},'tag {}'{})", block.keyword, block_id(index), owner_,
               block.name, at, shape, index, sample_.schema == "IFC2X3" ? "" : ",.NOTDEFINED.");
  }

  Point corner(const SampleBlock& block, int k) const {
    const auto bit = [&](bool on, int axis) {
      const auto i = static_cast<std::size_t>(axis);
      return sample_.coordinates[i] + (on ? block.size[i] : 0);
    };
    return {bit(k % 4 == 1 || k % 4 == 2, 0), bit(k % 4 >= 2, 1), bit(k >= 4, 2)};
  }

  std::string write_item(const SampleBlock& block) {
    if (sample_.shape == "brep") return write_brep(block);
    if (sample_.shape == "triangles" || sample_.shape == "polygons") return write_lists(block);
    if (sample_.shape == "advanced") return add("IFCADVANCEDBREP({})", up_);
    if (sample_.shape != "mapped") return write_extrusion(block);
    const std::string origin = add("IFCAXIS2PLACEMENT3D({},$,$)", point({0, 0, 0}));
    const std::string body = add("IFCSHAPEREPRESENTATION({},'Body','SweptSolid',({}))", context_,
                                 write_extrusion(block));
    const std::string map = add("IFCREPRESENTATIONMAP({},{})", origin, body);
    const std::string target =
        add("IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,{},1.,$)", point({0, 0, 0}));
    return add("IFCMAPPEDITEM({},{})", map, target);
  }

  std::string write_extrusion(const SampleBlock& block) {
    const double x = block.size[0] * per_metre_;
    const double y = block.size[1] * per_metre_;
    const std::string height = real(block.size[2] * per_metre_);
    if (sample_.shape == "indexed curve") {
      const std::string points =
          add("IFCCARTESIANPOINTLIST2D(((0.,0.),({0},0.),({0},{1}),(0.,{1})))", real(x), real(y));
      const std::string curve =
          add("IFCINDEXEDPOLYCURVE({},(IFCLINEINDEX((1,2,3,4)),IFCLINEINDEX((4,1))),.F.)", points);
      const std::string profile = add("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,{})", curve);
      return add("IFCEXTRUDEDAREASOLID({},$,{},{})", profile, up_, height);
    }
    if (sample_.shape.starts_with("IFC")) {
      const std::string profile = add("{}", sample_.shape);
      return add("IFCEXTRUDEDAREASOLID({},$,{},{})", profile, up_, height);
    }
    const bool bare = sample_.shape == "extrusion without positions";
    // Without positions the profile lies about the origin: the block is moved by its own corner.
    const std::string middle =
        bare ? "$"
             : add("IFCAXIS2PLACEMENT2D({},$)",
                   add("IFCCARTESIANPOINT(({},{}))", real(x / 2), real(y / 2)));
    const std::string profile =
        add("IFCRECTANGLEPROFILEDEF(.AREA.,$,{},{},{})", middle, real(x), real(y));
    const std::string position = bare ? "$" : add("IFCAXIS2PLACEMENT3D({},$,$)", point({0, 0, 0}));
    return add("IFCEXTRUDEDAREASOLID({},{},{},{})", profile, position, up_, height);
  }

  std::string write_brep(const SampleBlock& block) {
    std::array<std::string, 8> corners;
    for (int k = 0; k < 8; ++k) corners[static_cast<std::size_t>(k)] = point(corner(block, k));
    std::string faces;
    for (const auto& face : kFaces) {
      std::string loop;
      for (const int k : face) {
        loop += (loop.empty() ? "" : ",") + corners[static_cast<std::size_t>(k)];
      }
      const std::string bound = add("IFCFACEOUTERBOUND({},.T.)", add("IFCPOLYLOOP(({}))", loop));
      faces += (faces.empty() ? "" : ",") + add("IFCFACE(({}))", bound);
    }
    return add("IFCFACETEDBREP({})", add("IFCCLOSEDSHELL(({}))", faces));
  }

  std::string write_lists(const SampleBlock& block) {
    std::string list;
    for (int k = 0; k < 8; ++k) list += (k == 0 ? "" : ",") + numbers(corner(block, k));
    const std::string points = add("IFCCARTESIANPOINTLIST3D(({}))", list);
    std::string faces;
    for (const auto& f : kFaces) {
      if (!faces.empty()) faces += ',';
      if (sample_.shape == "triangles") {
        faces += fmt::format("({},{},{}),({},{},{})", f[0] + 1, f[1] + 1, f[2] + 1, f[0] + 1,
                             f[2] + 1, f[3] + 1);
      } else {
        faces +=
            add("IFCINDEXEDPOLYGONALFACE(({},{},{},{}))", f[0] + 1, f[1] + 1, f[2] + 1, f[3] + 1);
      }
    }
    if (sample_.shape == "triangles") {
      return add("IFCTRIANGULATEDFACESET({},$,.T.,({}),$)", points, faces);
    }
    return add("IFCPOLYGONALFACESET({},.T.,({}),$)", points, faces);
  }

  const IfcSample& sample_;
  double per_metre_ = 1000;
  int last_ = 0;
  std::string text_, owner_, context_, up_, project_;
  std::vector<std::string> storeys_, storey_places_;
};

}  // namespace

std::string ifc_text(const IfcSample& sample) { return SampleWriter(sample).write(); }

std::string block_id(std::size_t index) { return fmt::format("0block$_{:014}", index); }

}  // namespace rubicon::testing
